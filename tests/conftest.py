"""Settings of all tests."""

import structlog
from hypothesis import settings

# A loaded machine makes an example slow, not wrong.
settings.register_profile("hoistway", deadline=None)
settings.load_profile("hoistway")


def pytest_runtest_teardown() -> None:
    """Undo how a command set the logs up: its standard error is closed when its test is over, and the next test logs too."""
    structlog.reset_defaults()
