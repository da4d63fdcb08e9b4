"""The systemd unit and its settings file."""

import configparser
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from app.settings import load
from tests.deploy.test_compose import ROOT

UNIT = ROOT / "deploy/systemd/hoistway.service"
ENVIRONMENT = ROOT / "deploy/systemd/hoistway.env"


def unit() -> configparser.ConfigParser:
    parser = configparser.ConfigParser(strict=False, interpolation=None)
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    parser.read(UNIT, encoding="utf-8")
    return parser


def test_the_unit_is_told_of_readiness_and_watches_for_life() -> None:
    service = unit()["Service"]
    assert (service["Type"], service["NotifyAccess"], service["Restart"]) == ("notify", "main", "on-failure")
    assert int(service["WatchdogSec"]) == 30
    assert service["ExecStart"].endswith("hoistway serve")
    assert service["NoNewPrivileges"] == "yes"
    assert service["CapabilityBoundingSet"] == ""


def test_the_settings_file_sets_what_there_is_to_set_and_makes_a_server_that_may_start() -> None:
    lines = ENVIRONMENT.read_text(encoding="utf-8").splitlines()
    named = dict(line.lstrip("#").split("=", 1) for line in lines if re.match(r"#?HOISTWAY_[A-Z_]+=", line))
    given = dict(line.split("=", 1) for line in lines if line.startswith("HOISTWAY_"))
    assert load(environ=given).database == "sqlite:////var/lib/hoistway/hoistway.db"
    assert load(environ={**named, "HOISTWAY_ACCESS_KEY": "x" * 16, "HOISTWAY_METRICS_KEY": "y" * 16}).port == 8080


@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="systemd-analyze is not installed")
def test_systemd_takes_the_unit(tmp_path: Path) -> None:
    text = UNIT.read_text(encoding="utf-8").replace("/opt/hoistway/.venv/bin/hoistway", "/bin/true")
    file = tmp_path / "hoistway.service"
    file.write_text(re.sub(r"(?m)^(User|Group)=.*$", "", text), encoding="utf-8")
    done = subprocess.run(
        ["systemd-analyze", "verify", "--man=no", str(file)], capture_output=True, text=True, check=False
    )
    ours = [line for line in done.stderr.splitlines() if "hoistway.service" in line]
    assert (done.returncode, ours) == (0, [])
