import pytest

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.detect import VARIANTS, Variant, fits_of_stream, surviving
from app.protocols.itsc.dialects import DEFAULT, DIALECTS
from app.protocols.itsc.messages import NOTHING, Ack, Code, Enq, Nak
from tests.protocols.itsc.frames import a_move


def test_there_are_twenty_four_variants() -> None:
    assert len(set(VARIANTS)) == 24


@pytest.mark.parametrize("variant", VARIANTS, ids=lambda v: f"{v.crc}-{v.coverage}-{v.order}")
def test_three_acks_prove_the_variant(variant: Variant) -> None:
    codec = Codec(variant.on(DEFAULT))
    assert surviving(codec.encode(Ack(1, 1000 + i)) for i in range(3)) == [variant]


@pytest.mark.parametrize("name", ["default", "etb-no-sub-crc", "etb-one-crc"])
def test_other_packets_serve_too(name: str) -> None:
    codec = Codec(DIALECTS[name])
    packets = [codec.encode(Nak(1, 5)), codec.encode(Enq(1, 6, Code.STATUS, NOTHING)), codec.encode(a_move())]
    assert surviving(packets, codec.dialect) == [Variant("ccitt-false", True, "big")]  # noqa: FBT003


@pytest.mark.parametrize("packet", [b"", b"\x06", b"\x05" + bytes(31), b"\x17" + bytes(10), b"\x99" * 15])
def test_what_is_no_whole_packet_fits_nothing(packet: bytes) -> None:
    assert surviving([packet]) == []
    assert surviving([packet], DIALECTS["etb-one-crc"]) == []


def test_no_packets_prove_nothing() -> None:
    assert surviving([]) == []


def test_a_stream_with_noise_gives_the_best_variant_first() -> None:
    codec = Codec(DIALECTS["crc-arc"])
    stream = b"\xff\xff" + b"".join(codec.encode(Ack(1, i)) for i in range(4)) + b"\x06\x01"
    fits = fits_of_stream(stream)
    assert fits[0].variant == Variant("arc", True, "little")  # noqa: FBT003
    assert (fits[0].frames, fits[0].covered, fits[0].dropped) == (4, 60, 4)
    assert fits_of_stream(b"\xff" * 40) == []


def test_a_variant_names_the_preset_that_has_it() -> None:
    assert Variant("arc", True, "little").preset == "crc-arc"  # noqa: FBT003
    assert Variant("arc", False, "big").preset is None  # noqa: FBT003
