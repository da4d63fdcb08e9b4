"""What the controller says to what the page offers has not changed since the page was compared with it (tests/against.py)."""

import json
from collections.abc import Callable, Iterator

import pytest

from tests import against

REMEDY = "run python -m tests.against, then the page's tests (cd web && npm test), and mend web/src/against.ts"


@pytest.mark.parametrize("make", [against.hoists, against.agvs, against.devices, against.drives])
def test_the_orders_refuse_what_the_page_was_compared_with(make: Callable[[], Iterator[against.Case]]) -> None:
    kept = json.loads(against.FILE.read_text(encoding="utf-8"))[make.__name__]
    now = [json.loads(json.dumps(case)) for case in make()]
    assert len(now) == len(kept), REMEDY
    assert [(a["features"], a, b) for a, b in zip(now, kept, strict=True) if a != b] == [], REMEDY


def test_what_is_asked_and_where_has_not_changed_either() -> None:
    kept = json.loads(against.FILE.read_text(encoding="utf-8"))
    assert kept["asked"] == against.asked(), REMEDY
    assert kept["layouts"] == json.loads(json.dumps(against.layouts())), REMEDY
    assert [*kept] == ["asked", "layouts", "hoists", "agvs", "devices", "drives"]
