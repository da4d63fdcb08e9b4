"""The demo plant as ``make run`` starts it: everything in it is there, and an AGV carries a cart through the door."""

from pathlib import Path
from typing import Any

from tests.e2e.processes import GENEROUS, HTTP, free_ports, quick_plant, running, wait_until

QUICK_AGVS = "agv_defaults: {max_speed: 4000, curve_speed: 4000, acceleration: 4000, braking: 4000}\n"


def test_everything_in_the_demo_plant_is_there_and_an_agv_passes_the_door(tmp_path: Path) -> None:
    plant, log = quick_plant("demo", tmp_path), tmp_path / "demo.log"
    with plant.open("a", encoding="utf-8") as file:
        file.write(QUICK_AGVS)
    (port,) = free_ports(1)
    api = f"http://127.0.0.1:{port}/api/v1"

    def get(path: str) -> dict[str, Any]:
        found: dict[str, Any] = HTTP.get(f"{api}{path}", timeout=GENEROUS).json()
        return found

    def all_there() -> bool:
        return (
            all(vehicle["activity"] == "idle" for vehicle in get("/vehicles")["items"])
            and all(device["fresh"] for device in get("/devices")["items"])
            and all(drive["online"] for drive in get("/drives")["items"])
        )

    with running("demo", "--plant", str(plant), "--port", str(port), log=log):
        wait_until(lambda: b"Ctrl-C" in log.read_bytes(), "the invitation", log)
        wait_until(all_there, "everything in the plant", log)
        assert [len(get(path)["items"]) for path in ("/vehicles", "/devices", "/drives")] == [12, 6, 3]
        taken = HTTP.post(f"{api}/jobs", json={"source": "AB1", "destination": "AB4"}, timeout=GENEROUS)
        assert taken.status_code == 201, taken.text
        job = f"/jobs/{taken.json()['id']}"
        wait_until(lambda: get(job)["state"] == "completed", "the end of the job", log)
        refused = HTTP.post(f"{api}/jobs", json={"source": "ETCH01-P1", "destination": "AB2"}, timeout=GENEROUS)
        assert refused.status_code in {409, 422}, refused.text
    assert "Traceback" not in log.read_text(encoding="utf-8")
