"""Thousands of calls made of the committed OpenAPI document, sensible and not, against a real server by Schemathesis.

``python -m tests.acceptance.calls``: no 5xx, no answer that the document does not name, nothing accepted that it
forbids, and no memory that grows with the calls.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.e2e.processes import answers, free_ports, quick_plant, running, wait_until

DOCUMENT = Path(__file__).parents[2] / "openapi" / "openapi.json"
KEY = "a key that only this run knows"
CHECKS = "not_a_server_error,status_code_conformance,content_type_conformance,response_schema_conformance,negative_data_rejection"
REFUSALS = ["400", "401", "403", "404", "405", "406", "409", "413", "415", "422", "428", "429"]
"""What may answer a call that the document forbids; one longer than the body may be is refused before it is read (413)."""
LEFT_OUT = "stream|/live|/session"
"""Streams do not end; log-in and log-out would change who calls."""
GROWN = 20 << 20
"""Bytes that the server may grow by while it answers them all (QUALITY section 4)."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a run: how many calls were made, how much memory the server took more, and what was found."""

    cases: int
    grown: int
    well: bool
    report: str


def called(each: int, directory: Path, seed: int | None = None) -> Outcome:
    """Serve a plant whose vehicles are away, and make so many drawn calls of each route besides those at every bound of the
    document (some 5,000); ``seed`` draws the same again."""
    (port,) = free_ports(1)
    log, url = directory / "log", f"http://127.0.0.1:{port}"
    plant, database = str(quick_plant("small", directory)), f"sqlite:///{directory / 'plant.db'}"
    os.environ["HOISTWAY_ACCESS_KEY"] = KEY
    try:
        with running("serve", "--plant", plant, "--database", database, "--port", str(port), log=log) as server:
            wait_until(lambda: answers(url), "the server", log)
            _drive(url, 0, directory, seed)  # what is made once and kept is no growth
            before = _memory(server.pid)
            found = _drive(url, each, directory, seed)
            after = _memory(server.pid)
    finally:
        del os.environ["HOISTWAY_ACCESS_KEY"]
    made = re.search(r"(\d+) generated", found.stdout)
    return Outcome(int(made.group(1)) if made else 0, after - before, found.returncode == 0, found.stdout)


def _drive(url: str, each: int, directory: Path, seed: int | None) -> subprocess.CompletedProcess[str]:
    settings = directory / "schemathesis.toml"
    settings.write_text(f"[checks.negative_data_rejection]\nexpected-statuses = {json.dumps(REFUSALS)}\n")
    words = [
        sys.executable,
        "-m",
        "schemathesis.cli",
        "--config-file",
        str(settings),
        "run",
        str(DOCUMENT),
        "--url",
        url,
        "--no-color",
    ]
    words += ["-H", f"Authorization: Bearer {KEY}", "--checks", CHECKS, "--exclude-path-regex", LEFT_OUT]
    words += ["--phases", "coverage,fuzzing" if each else "fuzzing", "--max-examples", str(max(1, each))]
    words += ["--suppress-health-check", "all", "--request-timeout", "60"]
    words += [] if seed is None else ["--seed", str(seed)]
    return subprocess.run(words, capture_output=True, text=True, check=False, cwd=directory)


def _memory(process: int) -> int:
    """Return the bytes that a process has in memory; 0 where the system does not tell."""
    status = Path(f"/proc/{process}/status")
    found = re.search(r"VmRSS:\s+(\d+) kB", status.read_text()) if status.exists() else None
    return int(found.group(1)) * 1024 if found else 0


def main() -> int:
    """Run, print what was found, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--each", type=int, default=5, help="drawn calls of each route, besides those at all bounds")
    parser.add_argument("--seed", type=int, help="draw the same calls again")
    given = parser.parse_args()
    with TemporaryDirectory() as directory:
        outcome = called(given.each, Path(directory), given.seed)
    well = outcome.well and outcome.grown <= GROWN
    if not outcome.well:
        print(outcome.report)
    print(f"{outcome.cases} calls, {'all answered as the document says' if outcome.well else 'some not'}", end="; ")
    print(f"the server grew by {outcome.grown / 1e6:.1f} MB (at most {GROWN / 1e6:.0f})")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
