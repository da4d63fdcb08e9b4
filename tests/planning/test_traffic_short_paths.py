"""A vehicle whose paths are too short to come by all that it should not stand on."""

from collections.abc import Callable
from typing import TypeAlias

from app.domain.ids import VehicleId
from app.domain.units import Barcode
from app.planning.blocking import BlockReason
from app.planning.track import Track
from app.planning.traffic import Traffic

Lay: TypeAlias = Callable[..., Track]
V1 = VehicleId("V1")
AT = {
    "a": (0, 0),
    "b": (2000, 0),
    "c": (3000, 0),
    "d": (5000, 0),
    "x": (2500, 100),
    "y": (2500, 2000),
    "z": (2500, 4000),
}


def test_where_no_longer_path_can_be_told_it_may_stand_where_it_keeps_another_branch_from_passing(lay: Lay) -> None:
    """b and c are so near to x of another rail that whoever stands there keeps it shut."""
    traffic = Traffic(lay("a b c d", "x y z", at=AT, clearance=700), admission=True)
    wanted = (Barcode("b"), Barcode("c"))
    traffic.hold(V1, (Barcode("a"),))
    assert not any(map(traffic.may_end, wanted))
    refused = traffic.claim(V1, wanted, goal_included=False, beyond=(Barcode("d"),))
    assert refused.granted == ()
    assert refused.blocked is not None
    assert refused.blocked.why is BlockReason.NO_STOP
    assert traffic.claim(V1, wanted, goal_included=False, beyond=(Barcode("d"),), cut_short=True).granted == wanted
