import re

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.control.control import Control

RUN = CliRunner()
SMALL = ["fuzz", "--plant", "plants/small.yaml"]


def test_a_campaign_prints_what_it_reached_and_its_verdict() -> None:
    done = RUN.invoke(app, [*SMALL, "--seeds", "0-2", "--jobs", "1"])
    assert done.exit_code == 0, done.output
    assert "runs      3, of which 0 failed" in done.stdout
    assert "verdict   sound" in done.stdout


def test_a_failing_seed_prints_the_command_that_replays_it(monkeypatch: pytest.MonkeyPatch) -> None:
    decide = Control._decide

    def answered_at_once(self: Control) -> None:
        decide(self)
        for _, effects in self._uncommitted:
            self._replies += effects.replies
            effects.replies.clear()

    monkeypatch.setattr(Control, "_decide", answered_at_once)
    done = RUN.invoke(app, [*SMALL, "--seeds", "0", "--jobs", "1"])
    assert done.exit_code == 1
    assert "see it: hoistway fuzz --plant plants/small.yaml --replay 0 --trace --shrink" in done.stdout
    again = RUN.invoke(app, [*SMALL, "--replay", "0", "--trace", "--shrink"])
    assert again.exit_code == 1
    assert re.search(r"shrunk    from \d+ faults to 0", again.stdout)
    assert "violation at " in again.stdout


def test_a_replay_tells_step_by_step_and_gives_the_same_trace() -> None:
    one, two = (RUN.invoke(app, [*SMALL, "--replay", "1", "--trace"]).stdout for _ in range(2))
    assert one == two
    assert "TransferInitiated J000001" in one


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["--seeds", "9-3"], "the last comes before the first"),
        (["--seeds", "x"], "names no seeds"),
        (["--seeds", "0-2000000"], "more than 1,000,000"),
        (["--trace"], "--replay SEED"),
    ],
)
def test_what_cannot_be_run_is_refused_before_it_begins(given: list[str], said: str) -> None:
    done = RUN.invoke(app, [*SMALL, *given])
    assert done.exit_code == 1
    assert said in done.stderr
