"""The page about events names all that there are, and says how a job ends."""

import re
from pathlib import Path

from app.domain.job import JobEvent, JobState
from app.runtime.metrics.jobs import _ENDS

PAGE = (Path(__file__).parents[1] / "docs" / "events.md").read_text(encoding="utf-8")


def test_every_event_stands_in_a_table_once() -> None:
    rows = [line.split("|")[1] for line in PAGE.splitlines() if line.startswith("| `")]
    named = [name for row in rows for name in re.findall(r"`(\w+)`", row)]
    assert sorted(named) == sorted(map(str, JobEvent))


def test_the_events_that_end_a_job_and_its_results_are_named() -> None:
    paragraph = PAGE.partition("**Three events end a job**")[2].partition("\n\n")[0]
    assert {name for name in re.findall(r"`(\w+)`", paragraph) if name in set(JobEvent)} == set(_ENDS)
    assert {f"`{state}`" for state in JobState if state.terminal} <= set(re.findall(r"`\w+`", paragraph))
