"""The controller on the loop, against simulated vehicles behind real sockets in the same process."""

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, ExitStack, asynccontextmanager, suppress
from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.commands import Plain
from app.domain.errors import PlantError, PlantHeld, Refusal, StoreError
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId
from app.domain.job import JobState
from app.domain.layout import Plant
from app.domain.requests import Accepted, CommandVehicle, CreateJob, ReleaseVehicle, Verdict
from app.domain.units import Seconds
from app.domain.view import AlarmView, Topic, VehicleView
from app.plant import read
from app.protocols.itsc.simulator import Options
from app.runtime import controller as running
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.lines import Line
from app.runtime.transports import DeviceServer, Dialler, Tcp
from app.sim.plantworld import SimulatedPlant
from tests.e2e.processes import free_ports, quick_plant
from tests.runtime.peers import run, until

NOW = Clock().now
HASTY = Options(
    step_time=Seconds(0.02), servo_time=Seconds(0.02), search_home_time=Seconds(0.05), go_home_time=Seconds(0.05)
)
JOB = CreateJob(
    actor=Actor("test"),
    job=JobId("J1"),
    source="P1",
    destination=StationId("P2"),
    carrier=CarrierId("FOUP0001"),
    priority=50,
    fingerprint="1",
)


def plant_in(directory: Path) -> Plant:
    file = quick_plant("small", directory)
    plant, _ = read(file.read_text(encoding="utf-8"), file.name)
    return plant


def database_in(directory: Path) -> str:
    return f"sqlite:///{directory / 'plant.db'}"


@asynccontextmanager
async def simulated(plant: Plant) -> AsyncIterator[SimulatedPlant]:
    """Serve a plant's vehicles; those that dial in dial."""
    floor = SimulatedPlant(plant, options=HASTY, now=NOW())
    async with AsyncExitStack() as stack:
        for spec in plant.vehicles:
            line = Line(floor.devices[spec.id], NOW)
            if spec.listen:
                assert plant.listen is not None
                dialler = Dialler(line, Tcp(*plant.listen), spec.id)
                dialler.start()
                line.flush()
                stack.push_async_callback(dialler.stop)
            else:
                server = DeviceServer(line, spec.host, spec.port)
                await server.start()
                stack.push_async_callback(server.stop)
        yield floor


@asynccontextmanager
async def controlled(plant: Plant, directory: Path) -> AsyncIterator[Controller]:
    controller = Controller(plant, database_in(directory))
    await controller.start()
    try:
        yield controller
    finally:
        await controller.stop()


def vehicles(controller: Controller) -> list[VehicleView]:
    return [view for view in controller.model.all(Topic.VEHICLES) if isinstance(view, VehicleView)]


async def linked(controller: Controller) -> None:
    await until(lambda: sum(view.link.up for view in vehicles(controller)) == len(controller.plant.vehicles))


def in_pieces(tmp_path: Path, name: str) -> Path:
    """Return a directory for each loop that a scenario runs on."""
    directory = tmp_path / f"{name}{len(list(tmp_path.iterdir()))}"
    directory.mkdir()
    return directory


def test_a_job_goes_from_a_request_to_the_gripper_and_back(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "job")
        plant = plant_in(directory)
        async with simulated(plant) as floor, controlled(plant, directory) as controller:
            await linked(controller)
            assert await controller.ask(JOB) == Accepted("jobs", "J1", created=True)
            await until(lambda: floor.truth.at.get(StationId("P2")) == "FOUP0001")
            await until(lambda: controller.model.get(Topic.JOBS, "J1") is None)
            job = await asyncio.to_thread(controller.reader.job, JobId("J1"))
            assert job is not None
            assert job.state is JobState.COMPLETED
            assert controller.frames(VehicleId("V001"))
            assert controller.trouble == ""

    run(scenario)


def test_a_refusal_comes_back_with_its_reason(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "refusal")
        async with controlled(plant_in(directory), directory) as controller:
            reply = await controller.ask(replace(JOB, source="nowhere"))
            assert isinstance(reply, Refusal)
            assert "nowhere" in reply.reason

    run(scenario)


def test_a_second_controller_is_told_who_holds_the_plant(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "second")
        plant = plant_in(directory)
        async with controlled(plant, directory):
            with pytest.raises(PlantHeld, match="process"):
                await Controller(plant, database_in(directory)).start()

    run(scenario)


def test_after_a_stop_the_plant_is_free_and_jobs_go_on(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "again")
        plant = plant_in(directory)
        async with controlled(plant, directory) as controller:
            await controller.ask(JOB)
        async with simulated(plant) as floor, controlled(plant, directory) as controller:
            assert controller.model.get(Topic.JOBS, "J1") is not None
            await until(lambda: floor.truth.at.get(StationId("P2")) == "FOUP0001")

    run(scenario)


def test_a_vehicle_that_dials_in_is_controlled_like_any_other(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "listen")
        plant = plant_in(directory)
        coming = tuple(replace(spec, listen=True, host="") for spec in plant.vehicles)
        plant = replace(plant, vehicles=coming, listen=("127.0.0.1", free_ports(1)[0]))
        async with controlled(plant, directory) as controller, simulated(plant):
            await linked(controller)
            accepted = await controller.ask(CommandVehicle(Actor("test"), VehicleId("V002"), Plain.STATUS))
            assert isinstance(accepted, Accepted)

    run(scenario)


def test_a_vehicle_that_was_never_reached_says_why_and_no_more_once_it_is(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "unreached")
        plant = plant_in(directory)
        async with controlled(plant, directory) as controller:
            assert all(view.link.reason == "not connected yet" for view in vehicles(controller))
            # uvloop tells what the system says of it, asyncio itself what it tried.
            refused = ("Connection refused", "Connect call failed")
            await until(lambda: all(view.link.reason.startswith(refused) for view in vehicles(controller)))
            async with simulated(plant):
                await linked(controller)
                assert all(view.link.reason == "" for view in vehicles(controller))

    run(scenario)


def test_a_stranger_who_keeps_dialling_in_is_an_alarm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.runtime.listener.QUIET", 0.0)

    async def scenario() -> None:
        directory = in_pieces(tmp_path, "stranger")
        plant = plant_in(directory)
        coming = tuple(replace(spec, listen=True, host="192.0.2.1") for spec in plant.vehicles)
        (port,) = free_ports(1)
        async with controlled(replace(plant, vehicles=coming, listen=("127.0.0.1", port)), directory) as controller:
            for _ in range(2):
                reader, writer = await asyncio.open_connection("127.0.0.1", port)
                with suppress(ConnectionError):
                    assert await reader.read() == b""
                writer.close()
            await until(lambda: bool(controller.model.all(Topic.ALARMS)))
            (alarm,) = controller.model.all(Topic.ALARMS)
            assert isinstance(alarm, AlarmView)
            assert (alarm.kind, alarm.code) == ("plant", "stranger")
            assert "127.0.0.1 is not the address of any vehicle" in alarm.cause

    run(scenario)


def test_an_address_for_vehicles_that_is_taken_is_an_error_and_lets_the_plant_go(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "taken")
        plant = plant_in(directory)
        coming = tuple(replace(spec, listen=True, host="") for spec in plant.vehicles)
        server = await asyncio.get_running_loop().create_server(asyncio.Protocol, "127.0.0.1", 0)
        plant = replace(plant, vehicles=coming, listen=("127.0.0.1", server.sockets[0].getsockname()[1]))
        with pytest.raises(OSError, match="in use"):
            await Controller(plant, database_in(directory)).start()
        server.close()
        async with controlled(replace(plant, listen=("127.0.0.1", 0)), directory):
            pass

    run(scenario)


def test_a_start_at_a_taken_address_ends_also_while_vehicles_that_are_dialled_answer(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "answering")
        plant = plant_in(directory)
        first, *others = plant.vehicles
        with ExitStack() as stack:
            # The system accepts for them, so that the connections are made at the very moment of the refusal.
            taken, *peers = (stack.enter_context(socket.create_server(("127.0.0.1", 0))) for _ in plant.vehicles)
            dialled = [
                replace(spec, host="127.0.0.1", port=peer.getsockname()[1])
                for spec, peer in zip(others, peers, strict=True)
            ]
            vehicles = (replace(first, listen=True, host=""), *dialled)
            with pytest.raises(OSError, match="in use"):
                await Controller(
                    replace(plant, vehicles=vehicles, listen=taken.getsockname()), database_in(directory)
                ).start()

    run(scenario)


def test_another_plants_database_is_refused(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "other")
        plant = plant_in(directory)
        async with controlled(plant, directory):
            pass
        with pytest.raises(StoreError, match="small"):
            await Controller(replace(plant, name="other"), database_in(directory)).start()

    run(scenario)


def test_a_vehicle_that_may_be_on_the_rail_cannot_leave_the_plant_file(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "less")
        plant = plant_in(directory)
        less = replace(plant, vehicles=plant.vehicles[1:])
        async with simulated(plant), controlled(plant, directory) as controller:
            await linked(controller)
            await until(lambda: all(view.covered for view in vehicles(controller)))
        with pytest.raises(
            PlantError, match="V001 is not in the plant file any more, but may be on the rail"
        ) as caught:
            await Controller(less, database_in(directory)).start()
        assert "off_rail" in caught.value.remedy
        async with controlled(plant, directory) as controller:
            lifted = ReleaseVehicle(Actor("kim"), VehicleId("V001"), Verdict.OFF_RAIL, "lifted off")
            assert isinstance(await controller.ask(lifted), Accepted)
        async with controlled(less, directory):
            pass

    run(scenario)


def test_a_defect_ends_the_controller_and_everybody_who_waits_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "defect")
        plant = plant_in(directory)
        async with simulated(plant), controlled(plant, directory) as controller:
            await linked(controller)

            def broken(*_: object) -> None:
                raise ZeroDivisionError

            monkeypatch.setattr(controller._control, "transactions", broken)
            reply = await controller.ask(JOB)
            assert isinstance(reply, Refusal)
            assert "defect" in await controller.lost
            assert "defect" in controller.trouble
            assert isinstance(await controller.ask(JOB), Refusal)
            await until(lambda: not any(line.up for line in controller._lines.values()))

    run(scenario)


def test_who_is_not_answered_in_time_is_told_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "silence")
        async with controlled(plant_in(directory), directory) as controller:
            monkeypatch.setattr(controller._writer, "submit_all", lambda _batches: None)
            monkeypatch.setattr(running, "ANSWER_WITHIN", 0.0)
            with pytest.raises(TimeoutError):
                await controller.ask(JOB)
            assert not controller.trouble
            assert not controller._asked

    run(scenario)


def test_a_lost_lease_ends_the_controller(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "lease")
        plant = plant_in(directory)
        async with simulated(plant), controlled(plant, directory) as controller:
            await linked(controller)
            controller._writer._on_lost("another controller has the plant")
            assert await controller.lost == "another controller has the plant"
            await until(lambda: not any(line.up for line in controller._lines.values()))

    run(scenario)


def test_after_the_lease_has_run_out_not_a_byte_is_sent(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "stood")
        plant = plant_in(directory)
        async with controlled(plant, directory) as controller:
            assert controller._may_send()
            monkeypatch.setattr(type(controller._writer), "held_until", property(lambda _: NOW() - 1.0))
            assert not controller._may_send()
            assert "lease" in await controller.lost
            monkeypatch.undo()

    run(scenario)


def test_trouble_of_the_database_is_shown_until_it_is_over(tmp_path: Path) -> None:
    async def scenario() -> None:
        directory = in_pieces(tmp_path, "trouble")
        async with controlled(plant_in(directory), directory) as controller:
            controller._writer._on_trouble("the disk is full")
            await until(lambda: controller.trouble == "the disk is full")
            controller._writer._on_trouble("")
            await until(lambda: controller.trouble == "")

    run(scenario)
