"""Settings of all tests."""

from hypothesis import settings

# A loaded machine makes an example slow, not wrong.
settings.register_profile("hoistway", deadline=None)
settings.load_profile("hoistway")
