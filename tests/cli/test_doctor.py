"""``hoistway doctor``: it names what keeps a controller from running, and changes nothing."""

import json
import os
import socket
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.cli.doctor import machine
from app.domain.units import Timestamp
from app.store.backup import back_up, put_back
from app.store.ledger import SqlLedger
from app.store.schema import newest
from tests.store.samples import event

PLANT = """
name: P1
barcodes:
  1: [0, 0]
  2: [5000, 0]
  3: [5000, 5000]
  4: [0, 5000]
track:
  - {through: [1, 2, 3, 4, 1]}
vehicles:
  V1: {dev_id: 1, address: "127.0.0.1:PORT", start: 1, length: 500}
"""


@pytest.fixture(autouse=True)
def _no_settings_of_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in os.environ if name.startswith("HOISTWAY_")]:
        monkeypatch.delenv(name)


@pytest.fixture
def vehicle() -> Iterator[int]:
    """The port of somebody who takes connections."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]


def a_plant(tmp_path: Path, port: int, more: str = "") -> Path:
    file = tmp_path / "plant.yaml"
    file.write_text(PLANT.replace("PORT", str(port)) + more)
    return file


def ask(tmp_path: Path, *words: str) -> tuple[int, dict[str, list[tuple[str, str]]], str]:
    """The exit code, what was found as (verdict, message) by what was looked at, and all remedies."""
    url = f"sqlite:///{tmp_path}/plant.db"
    result = CliRunner().invoke(app, ["doctor", "--json", "--database", url, "--port", "0", *words])
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    found: dict[str, list[tuple[str, str]]] = {}
    for one in json.loads(result.stdout):
        found.setdefault(one["what"], []).append((one["verdict"], one["message"]))
    return result.exit_code, found, " ".join(one["remedy"] for one in json.loads(result.stdout))


def test_all_is_well_where_the_vehicle_answers_and_nothing_was_made(tmp_path: Path, vehicle: int) -> None:
    code, found, _ = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    assert code == 0
    assert found["lines"] == [("well", "1 of 1 vehicles and links take a connection")]
    assert found["database"] == [("well", "empty; the first start makes its tables")]
    assert [path.name for path in tmp_path.iterdir()] == ["plant.yaml"]


def test_a_silent_vehicle_is_named_with_its_address(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    code, found, remedies = ask(tmp_path, "--plant", str(a_plant(tmp_path, port)))
    assert code == 0
    assert found["vehicle V1"] == [("doubtful", f"127.0.0.1:{port} cannot be reached: Connection refused")]
    assert "another controller" in remedies


def test_nobody_is_knocked_at_while_a_controller_runs(tmp_path: Path, vehicle: int) -> None:
    ledger = SqlLedger(f"sqlite:///{tmp_path}/plant.db", "P1", "server A", lambda: Timestamp(0.0))
    code, found, _ = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    ledger.close()
    assert code == 0
    assert found["controller"][0][1].startswith("runs: server A")
    assert "vehicle V1" not in found
    assert found["database"] == [("well", f"plant P1, schema {newest()}")]


def test_a_controller_that_was_stopped_or_killed_does_not_count_as_running(tmp_path: Path, vehicle: int) -> None:
    SqlLedger(f"sqlite:///{tmp_path}/plant.db", "P1", "server A", lambda: Timestamp(0.0)).close()
    (tmp_path / "plant.db.lock").write_text("server B, killed")
    _, found, _ = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    assert "controller" not in found


def test_a_clock_behind_the_history_is_wrong(tmp_path: Path, vehicle: int) -> None:
    ledger = SqlLedger(f"sqlite:///{tmp_path}/plant.db", "P1", "server A", lambda: Timestamp(0.0))
    ledger.load()
    ledger.commit((event(int((time.time() + 1000) * 3)),))
    ledger.close()
    code, found, _ = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    assert code == 1
    assert any(verdict == "wrong" and "behind the newest event" in told for verdict, told in found["clock"])


def test_a_backup_that_was_put_back_is_told(tmp_path: Path, vehicle: int) -> None:
    url = f"sqlite:///{tmp_path}/plant.db"
    SqlLedger(url, "P1", "server A", lambda: Timestamp(0.0)).close()
    back_up(url, tmp_path / "monday.backup")
    put_back(tmp_path / "monday.backup", url, "me", Timestamp(1.0))
    _, found, remedies = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    assert ("doubtful", f"the backup {tmp_path}/monday.backup was put back") in found["database"]
    assert "holds every vehicle" in remedies


def test_a_taken_port_a_missing_serial_port_and_no_directory_are_wrong_each_with_a_remedy(
    tmp_path: Path, vehicle: int
) -> None:
    more = "links:\n  axes: {protocol: hi, serial: {device: /dev/none}}\ndrives:\n  AX1: {link: axes, id: 1}\n"
    plant = str(a_plant(tmp_path, vehicle, more))
    missing = f"sqlite:///{tmp_path}/none/plant.db"
    code, found, remedies = ask(tmp_path, "--plant", plant, "--port", str(vehicle), "--database", missing)
    assert code == 1
    assert found["server"][0][0] == "wrong"
    assert found["link axes"] == [("wrong", "there is no /dev/none")]
    assert found["disk"] == [("wrong", f"{tmp_path}/none does not exist")]
    assert "--port" in remedies
    assert "mkdir -p" in remedies


def test_what_cannot_be_read_is_told_and_the_rest_is_still_looked_at(tmp_path: Path) -> None:
    (tmp_path / "plant.db").write_bytes(b"lot,from,to\n" * 500)
    code, found, _ = ask(tmp_path, "--plant", str(tmp_path / "none.yaml"))
    assert code == 1
    assert found["database"][0][0] == "wrong"
    assert found["plant"][0][0] == "wrong"
    assert "server" in found


def test_a_full_disk_is_wrong_before_it_is_full(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, vehicle: int) -> None:
    monkeypatch.setattr(machine, "LEAST", 1 << 60)
    code, found, _ = ask(tmp_path, "--plant", str(a_plant(tmp_path, vehicle)))
    assert code == 1
    assert found["disk"][0][0] == "wrong"


def test_people_read_a_line_for_each_and_a_remedy_once(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as one, socket.create_server(("127.0.0.1", 0)) as other:
        ports = [server.getsockname()[1] for server in (one, other)]
    second = f'  V2: {{dev_id: 2, address: "127.0.0.1:{ports[1]}", start: 2, length: 500}}\n'
    plant = str(a_plant(tmp_path, ports[0], second))
    words = ["doctor", "--database", f"sqlite:///{tmp_path}/plant.db", "--plant", plant, "--port", "0"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0
    for name, port in zip(("V1", "V2"), ports, strict=True):
        assert f"vehicle {name}: 127.0.0.1:{port}" in result.stdout
    assert result.stdout.count("Does its controller program run?") == 1
    assert "0 wrong" in result.stdout


def test_a_wrong_setting_ends_the_look_with_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOISTWAY_PROT", "80")
    code, found, _ = ask(tmp_path)
    assert code == 1
    assert "did you mean port?" in found["settings"][0][1]
