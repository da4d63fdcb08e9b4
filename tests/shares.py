"""What ``make test`` does of a long test itself, and what it leaves to ``make campaign``, which does both."""

from typing import Any

import pytest


def shared(whole: list[Any], here: int) -> list[Any]:
    """Return the values of a parameter, all but the first few marked for the campaign."""
    return [*whole[:here], *(pytest.param(value, marks=pytest.mark.campaign) for value in whole[here:])]
