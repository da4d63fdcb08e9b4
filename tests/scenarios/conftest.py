"""What the scenarios stand on. ``track``, ``vehicle`` and ``places`` serve tests with a real controller's end as well."""

import pytest

from app.domain.units import Barcode
from app.protocols.itsc.simulator import Places, SimulatedVehicle, Track
from tests.scenarios.rig import Rig, small_track, spec


@pytest.fixture
def track() -> Track:
    """The rail of the scenarios."""
    return small_track()


@pytest.fixture
def places() -> Places:
    """The world around the vehicle."""
    return Places()


@pytest.fixture
def vehicle(track: Track, places: Places) -> SimulatedVehicle:
    """A vehicle in the start-up state at 1201."""
    return SimulatedVehicle(spec(), track, surroundings=places, start=Barcode("1201"))


@pytest.fixture
def rig(vehicle: SimulatedVehicle) -> Rig:
    """That vehicle with a scripted controller, AUTO and idle at 1201."""
    return Rig(vehicle).ready()


@pytest.fixture
def fresh(vehicle: SimulatedVehicle) -> Rig:
    """That vehicle with a scripted controller, in the start-up state."""
    return Rig(vehicle)
