"""What the controller's tests stand on."""

import pytest

from tests.control.bench import Bench


@pytest.fixture
def bench() -> Bench:
    """A controller with one vehicle, settled and idle in AUTO at 1201."""
    return Bench()
