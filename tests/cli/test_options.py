"""Options that make no sense are refused before anything runs."""

import socket
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.cli.plainly import CannotStart, said
from app.cli.running import bound

PLANT = str(Path(__file__).parents[2] / "plants" / "small.yaml")


@pytest.mark.parametrize(
    "words",
    [
        ["sim", "--plant", PLANT, "--haste", "0"],
        ["sim", "--plant", PLANT, "--haste", "nan"],
        ["sim", "--plant", PLANT, "--haste", "-1"],
        ["simulate", "--plant", PLANT, "--hours", "nan"],
        ["simulate", "--plant", PLANT, "--hours", "inf"],
        ["simulate", "--plant", PLANT, "--hours", "-1"],
        ["simulate", "--plant", PLANT, "--rate", "0"],
        ["simulate", "--plant", PLANT, "--keep", "0"],
        ["simulate", "--plant", PLANT, "--kills", "-1"],
        ["workload", "--rate", "nan"],
        ["workload", "--keep", "-1"],
        ["demo", "--keep", "0"],
        ["demo", "--operator", "-1"],
        ["sim", "--plant", PLANT, "--operator", "65536"],
    ],
    ids=" ".join,
)
def test_a_number_that_makes_no_sense_is_refused(words: list[str]) -> None:
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 2
    assert words[-2] in result.output


def test_a_port_that_is_taken_is_said_with_the_option_that_chose_it() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken, pytest.raises(CannotStart) as caught:
        bound("127.0.0.1", taken.getsockname()[1], "--operator")
    assert caught.value.remedy == "Choose another one with --operator."


def test_a_url_without_a_scheme_is_refused() -> None:
    result = CliRunner().invoke(app, ["workload", "--url", "localhost:8080"])
    assert result.exit_code == 1
    assert "http://127.0.0.1:8080" in result.output


def test_a_name_that_cannot_be_resolved_is_said_in_words() -> None:
    wrong = socket.gaierror(socket.EAI_NONAME, "Name or service not known")
    assert said(wrong) == "Name or service not known"


def test_ctrl_c_while_the_program_is_read_in_is_no_traceback() -> None:
    source = (
        "import builtins, sys\n"
        "real = builtins.__import__\n"
        "def interrupted(name, *rest):\n"
        "    if name == 'app.cli':\n"
        "        raise KeyboardInterrupt\n"
        "    return real(name, *rest)\n"
        "builtins.__import__ = interrupted\n"
        "from app.main import main\n"
        "main()\n"
    )
    ended = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True, timeout=60, check=False)
    assert (ended.returncode, ended.stderr) == (130, "")


def test_the_version_is_printed_for_who_reports_something() -> None:
    result = CliRunner().invoke(app, ["--version"])
    assert (result.exit_code, result.stdout.split()[0]) == (0, "hoistway")
    assert result.stdout.split()[1][0].isdigit()
