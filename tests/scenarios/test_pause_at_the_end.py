"""A vehicle that an obstacle pauses while it brakes for its end stops there, and goes no further (PROTOCOLS 5.1, I54)."""

import pytest

from app.domain.units import Barcode, Seconds
from app.protocols.itsc.messages import Oper
from app.protocols.itsc.simulator import SimulatedVehicle
from tests.scenarios.rig import Rig, small_track, spec

MOMENTS = [round(0.5 + 0.017 * n, 3) for n in range(80)]
"""From full speed on the way to 1202 until after the end there; each at another time of the clock, for its rounding."""


@pytest.mark.parametrize(("speed", "braking"), [(3000, 3000), (2870, 1700)])
def test_paused_at_any_moment_of_braking_it_ends_its_move_at_the_last_element(speed: int, braking: int) -> None:
    for after in MOMENTS:
        vehicle = SimulatedVehicle(spec(max_speed=speed, braking=braking), small_track(), start=Barcode("1201"))
        rig = Rig(vehicle).ready()
        rig.run(7 * after)
        rig.move(1201, 1202, speed=100)
        rig.run(after)
        vehicle.block_sensor(Seconds(rig.now))
        rig.run(3.0)
        vehicle.unblock_sensor(Seconds(rig.now))
        rig.run(10.0)
        assert vehicle.state.oper is Oper.IDLE, after
        assert vehicle.place(Seconds(rig.now))[:2] == ("1202", 0.0), after
