"""Panels of simulated drives, as set on the command line."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.cli.panel import set_panels
from app.domain.drive import DriveId
from app.domain.units import Seconds
from app.protocols.hi.messages import Mode
from app.protocols.hi.simulator import SimulatedDrive

HALL = str(Path(__file__).parents[2] / "plants" / "hall.yaml")


def test_a_panel_is_set_to_a_mode_or_an_error() -> None:
    drives = {DriveId(f"D{n}"): SimulatedDrive(n) for n in (1, 2)}
    set_panels(["D1=jog", "D2=error7"], drives, Seconds(0.0))
    assert drives[DriveId("D1")].state(Seconds(0.0)).mode is Mode.JOG
    state = drives[DriveId("D2")].state(Seconds(0.0))
    assert (state.mode, state.error) == (Mode.ERROR, 7)


@pytest.mark.parametrize(
    ("wish", "says"),
    [
        ("AX9=jog", "there is no drive 'AX9' in the plant there are: AX1"),
        ("AX1=fly", "a panel cannot be set to 'fly'"),
        ("AX1=error17", "error1 … error16"),
        ("AX1", "a panel cannot be set to ''"),
    ],
)
def test_a_panel_that_cannot_be_is_refused_before_anything_is_served(wish: str, says: str) -> None:
    result = CliRunner().invoke(app, ["sim", "--plant", HALL, "--panel", wish])
    assert result.exit_code == 1
    said = " ".join(result.output.split())
    assert all(word in said for word in says.split()), said
