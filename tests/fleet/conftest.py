"""What the fleet's tests stand on: ``Script`` plays sessions by hand, or lets toy vehicles obey."""

import pytest

from tests.fleet.script import B1, FOUP1, FOUP2, P1, Script


@pytest.fixture
def script() -> Script:
    """The small plant just started: no vehicle connected yet, FOUP0001 at P1, FOUP0002 at B1."""
    script = Script()
    script.fill(P1, FOUP1)
    script.fill(B1, FOUP2)
    return script


@pytest.fixture
def ready(script: Script) -> Script:
    """The same with V001 standing at 103 and V002 at 116, both connected, idle and obedient; nothing collected yet."""
    script.obey()
    script.forget()
    return script
