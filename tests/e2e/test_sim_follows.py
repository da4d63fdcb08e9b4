"""A simulated plant apart from its controller, which is given another version of the plant over REST."""

from pathlib import Path

import httpx
import pytest

from tests.e2e.processes import HTTP, answers, free_ports, quick_plant, running, wait_until
from tests.shares import shared

ACTOR = {"X-Actor": "kim"}


def activated(url: str, text: str) -> None:
    versions = f"{url}/api/v1/layout/versions"
    sent = {**ACTOR, "Content-Type": "application/yaml"}
    made = HTTP.post(versions, params={"reason": "a port more"}, content=text.encode(), headers=sent).json()
    body = {"reason": "it is built"}
    HTTP.post(f"{versions}/{made['number']}/activate", json=body, headers=ACTOR).raise_for_status()


@pytest.mark.parametrize("follows", shared([True, False], 1))
def test_a_simulator_follows_its_controller_or_says_what_it_does_not_know(tmp_path: Path, *, follows: bool) -> None:
    (port,) = free_ports(1)
    file, log, simulated = quick_plant("small", tmp_path), tmp_path / "log", tmp_path / "sim.log"
    text, url = file.read_text(encoding="utf-8"), f"http://127.0.0.1:{port}"
    with_p9 = text.replace("  B1: {", "  P9: {kind: port, at: 108, dest: {shft: 5, rota: 5, lift: 500}}\n  B1: {")
    server = ("serve", "--plant", str(file), "--database", f"sqlite:///{tmp_path}/plant.db", "--port", str(port))
    simulator = ("sim", "--plant", str(file), *(("--from", url) if follows else ()))

    def said(words: str) -> None:
        wait_until(lambda: words.encode() in simulated.read_bytes(), words, simulated)

    def taught() -> bool:
        dest = {"shft": 5, "rota": 5, "lift": 500}
        try:
            return HTTP.put(f"{url}/api/v1/stations/P9/dest", json=dest, headers=ACTOR).is_success
        except httpx.TransportError:
            return False  # it changes over

    with running(*server, log=log), running(*simulator, log=simulated):
        wait_until(lambda: answers(url), "the server", log)
        said("follows version 1" if follows else "are there")
        activated(url, with_p9)
        if follows:
            said("follows version 2")
        wait_until(taught, "the new port", log)
        body = {"job_id": "LOT-1", "source": "P1", "destination": "P9"}
        HTTP.post(f"{url}/api/v1/jobs", json=body, headers=ACTOR).raise_for_status()
        if follows:
            wait_until(lambda: '"state":"completed"' in HTTP.get(f"{url}/api/v1/jobs/LOT-1").text, "the delivery", log)
            assert b"not known here" not in simulated.read_bytes()
        else:
            said("V001 was sent to a station at barcode 108, which is not known here")
            alarm = "203 place taken"
            wait_until(lambda: alarm in HTTP.get(f"{url}/api/v1/alarms").text, "its alarm, by name", log)
