"""``hoistway bench rules`` says what the rule of admission is worth."""

import re

from typer.testing import CliRunner

from app.cli import app


def test_only_the_whole_rule_keeps_every_network_from_locking_up() -> None:
    answer = CliRunner().invoke(app, ["bench", "rules", "--networks", "12", "--steps", "500"])

    locked = {line.split("  ")[0].strip(): int(n) for line in answer.output.splitlines() if (n := _locked(line))}
    assert answer.exit_code == 0
    assert locked["look-ahead"] == 0
    assert all(locked[other] > 0 for other in ("none", "no hole", "no dwellers"))


def _locked(line: str) -> str:
    found = re.search(r"(\d+) of 12 networks", line)
    return found[1] if found else ""
