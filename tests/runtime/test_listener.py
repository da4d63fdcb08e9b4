import asyncio
import time

from app.domain.ids import DevId, VehicleId
from app.domain.layout import VehicleSpec
from app.domain.units import Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Ack, Code, Enq, Resp2, Toward, status1, status2
from app.runtime.lines import Line
from app.runtime.listener import Expected, Listener
from tests.runtime.peers import Echo, run, until

CODEC = Codec(DEFAULT)
ANSWER = Resp2(status1(0), status2(0), 1001, 0)


def now() -> Seconds:
    return Seconds(time.monotonic())


class Ears(Echo):
    """Takes bytes and says nothing."""

    def received(self, data: bytes, now: Seconds) -> None:
        self.notes.append("bytes")


class Bay:
    """A listener and the vehicles it expects, each (id, DEV_ID, allowed address)."""

    def __init__(self, *vehicles: tuple[str, int, str], ask_timeout: float = 1.0) -> None:
        self.ears = {name: Ears() for name, _, _ in vehicles}
        self.lines = {name: Line(self.ears[name], now) for name, _, _ in vehicles}
        self.reports: list[str] = []
        expected = [
            Expected(VehicleSpec(VehicleId(name), DevId(dev_id), host=host, listen=True), self.lines[name], CODEC)
            for name, dev_id, host in vehicles
        ]
        self.listener = Listener("127.0.0.1", 0, expected, self.reports.append, ask_timeout)

    async def __aenter__(self) -> "Bay":
        await self.listener.start()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.listener.stop()
        for line in self.lines.values():
            await line.disconnected()

    async def dial(self) -> "Vehicle":
        reader, writer = await asyncio.open_connection("127.0.0.1", self.listener.port)
        return Vehicle(reader, writer)


class Vehicle:
    """A vehicle that dials in; answers to its id alone."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader, self.writer = reader, writer
        self.asked: list[int] = []
        self.acked = False

    async def answer_as(self, dev_id: int) -> None:
        decoder = Decoder(CODEC, Toward.VEHICLE)
        while not self.acked and (data := await self.reader.read(1000)):
            for frame in decoder.feed(data):
                if isinstance(frame, Enq):
                    self.asked.append(frame.dev_id)
                    if frame.dev_id == dev_id:
                        self.writer.write(CODEC.ack(dev_id, frame.cmd_id))
                        self.writer.write(CODEC.encode(Enq(dev_id, frame.cmd_id, int(Code.STATUS), ANSWER)))
                self.acked = self.acked or isinstance(frame, Ack)

    async def gone(self) -> bool:
        try:
            return await self.reader.read(1000) == b""
        except ConnectionError:
            return True
        finally:
            self.writer.close()


def test_a_vehicle_is_known_by_its_address() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, "127.0.0.1"), ("V2", 2, "10.0.0.9")) as bay:
            vehicle = await bay.dial()
            await until(lambda: bay.ears["V1"].notes == ["connected"])
            vehicle.writer.close()
        assert bay.reports == []

    run(scenario)


def test_a_vehicle_at_a_shared_address_is_asked_who_it_is() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, "")) as bay:
            vehicle = await bay.dial()
            await vehicle.answer_as(2)
            await until(lambda: bay.ears["V2"].notes == ["connected"])
            assert vehicle.asked == [1, 2]
            assert vehicle.acked
            vehicle.writer.close()

    run(scenario)


def test_an_event_of_its_own_names_a_vehicle_and_reaches_its_session() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, "")) as bay:
            vehicle = await bay.dial()
            vehicle.writer.write(CODEC.encode(Enq(2, 1 << 63 | 5, int(Code.STATUS), ANSWER)))
            await until(lambda: bay.ears["V2"].notes == ["connected", "bytes"])
            vehicle.writer.close()

    run(scenario)


def test_a_stranger_is_refused_and_reported() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, "10.0.0.9")) as bay:
            vehicle = await bay.dial()
            assert await vehicle.gone()
            assert bay.reports == ["127.0.0.1 is not the address of any vehicle that may dial in"]

    run(scenario)


def test_a_second_claimant_is_refused_and_reported() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, "127.0.0.1")) as bay:
            first = await bay.dial()
            await until(lambda: bay.lines["V1"].up)
            second = await bay.dial()
            assert await second.gone()
            assert bay.reports == ["127.0.0.1 claims to be V1, which is connected already"]
            assert bay.ears["V1"].notes == ["connected"]
            first.writer.close()

    run(scenario)


def test_a_second_claimant_of_a_dev_id_is_refused_and_reported() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, "")) as bay:
            first = await bay.dial()
            await first.answer_as(1)
            await until(lambda: bay.lines["V1"].up)
            second = await bay.dial()
            second.writer.write(CODEC.encode(Enq(1, 1 << 63 | 5, int(Code.STATUS), ANSWER)))
            await until(lambda: bool(bay.reports))
            assert bay.reports == ["127.0.0.1 claims to be V1, which is connected already"]
            assert bay.lines["V1"].up
            for vehicle in (first, second):
                vehicle.writer.close()

    run(scenario)


def test_an_unknown_dev_id_is_refused_and_reported() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, "")) as bay:
            vehicle = await bay.dial()
            vehicle.writer.write(CODEC.encode(Enq(77, 1 << 63 | 5, int(Code.STATUS), ANSWER)))
            await until(lambda: bool(bay.reports))
            assert bay.reports == ["127.0.0.1 has DEV_ID 77, which no vehicle that may come from there has"]
            vehicle.writer.close()

    run(scenario)


def test_a_peer_that_goes_before_it_is_known_is_forgotten() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, "")) as bay:
            vehicle = await bay.dial()
            await until(lambda: bool(bay.listener._asking))
            vehicle.writer.close()
            await until(lambda: not bay.listener._asking)
            assert bay.reports == []

    run(scenario)


def test_a_silent_peer_is_cut_off_in_the_end() -> None:
    async def scenario() -> None:
        async with Bay(("V1", 1, ""), ("V2", 2, ""), ask_timeout=0.01) as bay:
            vehicle = await bay.dial()
            while await vehicle.reader.read(1000):
                pass
            assert bay.reports == ["127.0.0.1 answers to no id that is missing"]
            vehicle.writer.close()

    run(scenario)
