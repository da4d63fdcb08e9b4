"""What holds for each of the curl scripts: they say what they take, send what they were told, and show why they were refused."""

import json
import os
import re
import subprocess
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from app.plant import read
from tests.e2e.processes import GENEROUS

SCRIPTS = Path(__file__).parents[2] / "examples" / "curl"
QUOTED = 'say "new" \\ port\'s 포트'
"""A reason as people write them: with all that JSON and a shell could trip over."""
KEY = "hw_the-key"
WHY = "no, and here is why"
ASKING_NOBODY = {"closure-place.sh"}
GIVEN = {
    "KIND": ("barcode",), "NAME": ("103",), "DEVICE": ("DOOR1",), "COMMAND": ("open",), "DOOR": ("DOOR1",), "BUFFER": ("B1",),
    "DRIVE": ("AX1",), "BACKUP": ("12",), "BACKUP|DRIVE": ("12",), "LINE": ("axes",), "PARAMETER": ("00",), "VALUE": ("2.5",),
    "WALK": ("1",), "STATION": ("B1",), "NUMBER": ("1",), "VERSION": ("2",), "ONE": ("1",), "OTHER": ("2",), "REASON": (QUOTED,),
    "[NOTE]": (QUOTED,), "[REASON]": (QUOTED,), "REASON|--lift": (QUOTED,), "FROM": ("2026-07-01T08:30:00Z",),
    "TO": ("2026-07-01T08:45:00Z",), "FILE": ("dests.csv",), "FILE.csv": ("dests.csv",),
}  # fmt: skip
"""What is given for a word of a usage; for those not here: the first of a choice, and nothing for those in brackets."""


def scripts() -> list[str]:
    """Return every script that takes its words by ``usage``, by its name below ``examples/curl``."""
    found = sorted(file.relative_to(SCRIPTS).as_posix() for file in SCRIPTS.rglob("[!_]*.sh"))
    return [name for name in found if name != "mes.sh"]  # it has tests of its own: test_mes.py


def words_of(script: str) -> list[str]:
    """Return the words that a script takes, as it calls them."""
    taken = re.search(r'^usage "([^"]*)" "\$@"$', (SCRIPTS / script).read_text(encoding="utf-8"), re.MULTILINE)
    assert taken is not None, f"{script} does not say what it takes"
    return taken[1].split()


def run(script: str, *words: str, url: str = "http://127.0.0.1:9", **env: str) -> subprocess.CompletedProcess[str]:
    """Run a script in the directory that ``env`` names as ``PWD``."""
    return subprocess.run(
        ["bash", str(SCRIPTS / script), *words],
        capture_output=True,
        text=True,
        timeout=GENEROUS,
        check=False,
        stdin=subprocess.DEVNULL,
        cwd=env.get("PWD"),
        env={**os.environ, "HOISTWAY": url, "ACTOR": "kim", **env},
    )


class Refusing(BaseHTTPRequestHandler):
    """Refuses whatever it is asked, as the controller does, and keeps what was sent."""

    sent: list[bytes]

    def answer(self) -> None:
        """Refuse."""
        if self.headers.get("Authorization") != f"Bearer {KEY}":
            self.sent.append(b"no key")
        self.sent.append(self.rfile.read(int(self.headers.get("Content-Length", 0))))
        body = json.dumps({"status": 409, "detail": WHY, "remedy": "ask later"}).encode()
        self.send_response(409)
        self.send_header("Content-Type", "application/problem+json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    do_GET = do_POST = do_PUT = do_DELETE = answer  # noqa: N815 -- as http.server calls them

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@pytest.fixture
def refusing() -> Iterator[tuple[str, list[bytes]]]:
    """The address of a controller that refuses everything, and the bodies that were sent to it."""
    sent: list[bytes] = []
    handler = type("Handler", (Refusing,), {"sent": sent})
    with HTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}", sent
        server.shutdown()
        thread.join()


@pytest.mark.parametrize("script", scripts())
def test_a_script_without_its_words_says_which_it_takes(script: str, tmp_path: Path) -> None:
    helped = run(script, "--help")
    assert (helped.returncode, helped.stderr) == (0, "")
    assert helped.stdout.startswith(f"usage: {' '.join((Path(script).name, *words_of(script)))}\n")
    assert len(helped.stdout.splitlines()) > 1
    if needed := [word for word in words_of(script) if not word.startswith("[")]:
        bare = run(script, PWD=str(tmp_path))
        assert (bare.returncode, bare.stdout) == (2, "")
        assert bare.stderr == f"missing: {' '.join(needed)}\n{helped.stdout}"


@pytest.mark.parametrize("script", [name for name in scripts() if name not in ASKING_NOBODY])
def test_a_refusal_is_shown_and_what_was_told_is_sent(
    script: str, refusing: tuple[str, list[bytes]], tmp_path: Path
) -> None:
    url, sent = refusing
    (tmp_path / "dests.csv").write_text("station,version,shft,rota,lift\nP1,1,1,1,1\n")
    words: list[str] = []
    for word in words_of(script):
        words += GIVEN.get(word, () if word.startswith("[") else (word.split("|")[0],))
    ended = run(script, *words, url=url, PWD=str(tmp_path), REASON=QUOTED, HOISTWAY_KEY=KEY)
    shown = ended.stdout + ended.stderr
    assert ended.returncode not in (0, 2), ended
    assert WHY in shown
    assert "ask later" in shown
    assert "Traceback" not in shown
    assert re.search(r"\.sh: line \d+", shown) is None, shown
    assert sent
    assert b"no key" not in sent
    bodies = [json.loads(body) for body in sent if body.startswith(b"{")]
    if QUOTED in words and bodies:
        assert any(QUOTED in body.values() for body in bodies), bodies


@pytest.mark.parametrize("script", [name for name in scripts() if name not in ASKING_NOBODY and not words_of(name)])
def test_a_controller_that_is_not_there_is_no_empty_answer(script: str) -> None:
    ended = run(script)
    assert ended.returncode not in (0, 2)
    assert "127.0.0.1" in ended.stderr
    assert "Traceback" not in ended.stderr


def test_a_place_is_json_whatever_its_name_is() -> None:
    for words, place in (
        (("barcode", 'A"1'), {"kind": "barcode", "barcodes": ['A"1']}),
        (("edge", "1", "2"), {"kind": "edge", "from": "1", "to": "2"}),
        (("stretch", "1", "2"), {"kind": "stretch", "from": "1", "to": "2"}),
        (("zone", "east \\ west"), {"kind": "zone", "zone": "east \\ west"}),
        (("station", "P1"), {"kind": "station", "station": "P1"}),
    ):
        assert json.loads(run("closure-place.sh", *words).stdout) == place
    half = run("closure-place.sh", "edge", "1")
    assert (half.returncode, half.stderr.splitlines()[:2]) == (
        2,
        ["missing: TO", "usage: closure-place.sh edge FROM TO"],
    )
    other = run("closure-place.sh", "bay", "1")
    assert (other.returncode, other.stderr) == (
        2,
        "no such kind of place: bay; barcode, edge, stretch, zone or station\n",
    )


def test_what_has_to_be_a_number_and_is_none_is_refused_by_its_name() -> None:
    ended = run("closure-close.sh", "why", "barcode", "1", MINUTES="ten")
    assert (ended.returncode, ended.stdout) == (1, "")
    assert ended.stderr == "minutes: 'ten' is no number, and none of true, false, null\n"


def test_each_script_asks_by_the_one_function_that_shows_refusals() -> None:
    """``drive-jog.sh`` may beat by a curl of its own, ``watch.sh`` read a stream, ``reteach-lift.sh`` ask a simulator."""
    of_their_own = {"drive-jog.sh", "teaching/watch.sh", "teaching/reteach-lift.sh"}
    asking = {
        name
        for name in scripts()
        if re.search(r"^[^#]*\b(?:curl|keyed) ", (SCRIPTS / name).read_text(encoding="utf-8"), re.MULTILINE)
    }
    assert asking == of_their_own


def test_places_that_the_page_about_closures_names_are_of_the_plant_that_make_run_shows() -> None:
    root = SCRIPTS.parents[1]
    plant, _ = read((root / "plants" / "demo.yaml").read_text(encoding="utf-8"), "demo.yaml")
    known: dict[str, set[str]] = {
        "barcode": {point.barcode for point in plant.points},
        "zone": {zone.id for zone in plant.zones},
        "station": {station.id for station in plant.stations},
    }
    known["edge"] = known["stretch"] = known["barcode"]
    texts = [(root / "docs" / "closures.md").read_text(encoding="utf-8")]
    texts += [file.read_text(encoding="utf-8") for file in sorted(SCRIPTS.glob("closure-*.sh"))]
    named: set[str] = set()
    for text in texts:
        for kind, *names in re.findall(r"\b(barcode|edge|stretch|zone|station) ([A-Z\d][\w-]+)(?: (\d+))?", text):
            named.add(kind)
            assert {name for name in names if name} <= known[kind], (kind, names)
        for zone in re.findall(r"/zones/([\w-]+)/", text):
            assert zone in known["zone"] | {"ZONE"}
    assert named == set(known)
