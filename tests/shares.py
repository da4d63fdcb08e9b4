"""What ``make test`` does of a long test itself, and what it leaves to ``make campaign``, which does both."""

from typing import Any

import pytest


def shared(whole: list[Any], here: int) -> list[Any]:
    """Return the values of a parameter (or tuples of several), all but the first few marked for the campaign."""
    rest = (value if isinstance(value, tuple) else (value,) for value in whole[here:])
    return [*whole[:here], *(pytest.param(*values, marks=pytest.mark.campaign) for values in rest)]
