"""Commands as a person types them: what they say, how they end, and that nothing of them is left."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest
import typer
import yaml

from app.cli import app
from tests.e2e.processes import COMMAND, GENEROUS, HTTP, answers, free_ports, quick_plant, running, wait_until

ROOT = Path(__file__).parents[2]


def hoistway(*arguments: str, **env: str) -> subprocess.CompletedProcess[str]:
    """Run a command that ends by itself."""
    return subprocess.run(
        [*COMMAND, *arguments], capture_output=True, text=True, timeout=GENEROUS, env={**os.environ, **env}, check=False
    )


def assert_one_clear_line(ended: subprocess.CompletedProcess[str], *words: str) -> None:
    assert ended.returncode == 1, ended
    assert "Traceback" not in ended.stderr
    last = ended.stderr.strip().splitlines()[-1]
    assert last.startswith("hoistway: ")
    for word in words:
        assert word in last


def children_of(process: subprocess.Popen[bytes]) -> list[int]:
    found = subprocess.run(
        ["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True, check=False
    )
    return [int(pid) for pid in found.stdout.split()]


def is_alive(pid: int) -> bool:
    stat = Path(f"/proc/{pid}/stat")
    try:
        return stat.read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def jobs_at(url: str) -> list[object]:
    items: list[object] = HTTP.get(f"{url}/api/v1/jobs").json()["items"]
    return items


@pytest.fixture
def plant(tmp_path: Path) -> Path:
    return quick_plant("small", tmp_path)


def test_the_demo_prints_one_line_to_try_that_works_and_ends_cleanly_on_ctrl_c(plant: Path, tmp_path: Path) -> None:
    (port,) = free_ports(1)
    log = tmp_path / "demo.log"
    with running("demo", "--plant", str(plant), "--port", str(port), log=log) as demo:
        wait_until(lambda: b"Ctrl-C" in log.read_bytes(), "the invitation", log)
        said = log.read_text()
        assert f"http://127.0.0.1:{port}" in said
        (line,) = (line for line in said.splitlines() if line.strip().startswith("curl "))
        body = re.search(r"-d '(.*)'", line)
        assert body is not None
        answer = HTTP.post(f"http://127.0.0.1:{port}/api/v1/jobs", json=json.loads(body[1]))
        assert answer.status_code == 201, answer.text
        job = answer.json()["id"]
        url = f"http://127.0.0.1:{port}/api/v1/jobs/{job}"
        wait_until(lambda: HTTP.get(url).json()["state"] == "completed", "the end of the job", log)
        simulators = children_of(demo)
        assert len(simulators) == 1
        demo.send_signal(signal.SIGINT)
        assert demo.wait(GENEROUS) == 0
        wait_until(lambda: not any(map(is_alive, simulators)), "the simulator's end")
    assert "Traceback" not in log.read_text()


def test_a_killed_demo_leaves_no_simulator_behind(plant: Path, tmp_path: Path) -> None:
    (port,) = free_ports(1)
    log = tmp_path / "demo.log"
    with running("demo", "--plant", str(plant), "--port", str(port), "--workload", log=log) as demo:
        wait_until(lambda: b"Ctrl-C" in log.read_bytes(), "the invitation", log)
        simulators = children_of(demo)
        assert simulators
        demo.kill()
        demo.wait()
        wait_until(lambda: not any(map(is_alive, simulators)), "the simulator's end")


def test_the_workload_orders_jobs(plant: Path, tmp_path: Path) -> None:
    (port,) = free_ports(1)
    url = f"http://127.0.0.1:{port}"
    database = f"sqlite:///{tmp_path / 'plant.db'}"
    serve = ("serve", "--plant", str(plant), "--database", database, "--port", str(port))
    log = tmp_path / "workload.log"
    with running("workload", "--url", url, "--keep", "2", "--seed", "1", log=log) as workload:
        with running(*serve, log=tmp_path / "serve.log") as server:
            wait_until(lambda: answers(url), "the server", tmp_path / "serve.log")
            wait_until(lambda: len(jobs_at(url)) == 2, "two jobs", log)
            server.send_signal(signal.SIGTERM)
            assert server.wait(GENEROUS) == 0
        workload.send_signal(signal.SIGINT)
        assert workload.wait(GENEROUS) == 0
    assert "Traceback" not in log.read_text()


def test_a_second_server_on_the_same_plant_says_who_holds_it(plant: Path, tmp_path: Path) -> None:
    one, other = free_ports(2)
    database = f"sqlite:///{tmp_path / 'plant.db'}"
    arguments = ("serve", "--plant", str(plant), "--database", database, "--port")
    with running(*arguments, str(one), log=tmp_path / "serve.log") as first:
        wait_until(lambda: answers(f"http://127.0.0.1:{one}"), "the server", tmp_path / "serve.log")
        assert_one_clear_line(hoistway(*arguments, str(other)), f"process {first.pid}")


def test_a_port_in_use_is_one_clear_line(plant: Path, tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        database = f"sqlite:///{tmp_path / 'plant.db'}"
        for command in (("serve", "--database", database), ("demo",)):
            ended = hoistway(*command, "--plant", str(plant), "--port", port)
            assert_one_clear_line(ended, f"cannot listen at 127.0.0.1:{port}", "--port")


def test_vehicles_that_are_simulated_already_are_one_clear_line(plant: Path, tmp_path: Path) -> None:
    log = tmp_path / "sim.log"
    with running("sim", "--plant", str(plant), log=log) as sim:
        wait_until(lambda: b"are there" in log.read_bytes(), "the simulated vehicles", log)
        addresses = re.findall(r"127\.0\.0\.1:\d+", plant.read_text(encoding="utf-8"))
        for command in (("sim",), ("demo", "--port", str(free_ports(1)[0]))):
            ended = hoistway(*command, "--plant", str(plant))
            assert_one_clear_line(ended, *addresses, "(V001)", "Is it simulated already?", str(plant))
        sim.send_signal(signal.SIGINT)
        assert sim.wait(GENEROUS) == 0


@pytest.mark.parametrize("command", [("serve",), ("sim",), ("demo",), ("simulate",)])
def test_a_plant_file_that_is_missing_or_wrong_is_one_clear_line(command: tuple[str, ...], tmp_path: Path) -> None:
    assert_one_clear_line(hoistway(*command, "--plant", "no/such.yaml"), "no/such.yaml", "No such file")
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text("name: wrong\n", encoding="utf-8")
    assert_one_clear_line(hoistway(*command, "--plant", str(wrong)), f"hoistway check {wrong}")


def test_a_server_without_a_plant_or_open_to_the_world_without_a_key_is_refused(plant: Path) -> None:
    assert_one_clear_line(hoistway("serve"), "which plant?", "--plant")
    assert_one_clear_line(hoistway("serve", "--plant", str(plant), "--host", "0.0.0.0"), "access_key")
    assert_one_clear_line(hoistway("serve", "--plant", str(plant), HOISTWAY_PRT="1"), "HOISTWAY_PORT".lower()[9:])


def test_a_database_that_cannot_be_opened_is_one_clear_line(plant: Path) -> None:
    (port,) = free_ports(1)
    arguments = ("--plant", str(plant), "--port", str(port), "--database", "sqlite:////no/such/directory/x.db")
    assert_one_clear_line(hoistway("serve", *arguments), "directory")


def test_a_virtual_run_prints_its_verdict(plant: Path) -> None:
    ended = hoistway("simulate", "--plant", str(plant), "--hours", "0.02", "--seed", "3", "--keep", "2", "--kills", "1")
    assert ended.returncode == 0, ended
    for word in ("completed", "trace", "verdict        sound", "x real time"):
        assert word in ended.stdout


def test_help_is_quick_since_nothing_heavy_is_imported_for_it() -> None:
    heavy = ("fastapi", "sqlalchemy", "numpy", "scipy", "networkx", "uvicorn", "httpx")
    code = f"import sys, app.cli; print([name for name in {heavy} if name in sys.modules])"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=GENEROUS)
    assert found.stdout.strip() == "[]"


def test_what_the_compose_file_runs_are_commands_that_exist(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    compose = yaml.safe_load((ROOT / "docker-compose.yml").read_text(encoding="utf-8"))
    assert set(compose["services"]) == {"database", "plant", "controller", "prometheus", "grafana"}
    group = typer.main.get_group(app)
    ran = [compose["services"][ours]["command"] for ours in ("plant", "controller")]
    assert [arguments[0] for arguments in ran] == ["sim", "serve"]
    for name, *arguments in ran:
        command = group.commands[name]
        context = command.make_context(name, list(arguments))
        assert Path(context.params["plant"]).is_file()
    for service in compose["services"].values():
        for dependency in service.get("depends_on", {}):
            assert dependency in compose["services"]


def test_the_locks_pin_everything_with_hashes_and_name_no_registry() -> None:
    for name in ("runtime", "dev"):
        text = (ROOT / "requirements" / f"{name}.txt").read_text(encoding="utf-8")
        pins = re.findall(r"^[a-z0-9][\w.\-\[\]]*==\S+.*$", text, flags=re.MULTILINE | re.IGNORECASE)
        assert len(pins) > 20
        assert text.count("--hash=sha256:") >= len(pins)
        assert "://" not in text
        assert "--index" not in text
