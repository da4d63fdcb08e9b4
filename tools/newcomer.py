"""Follows README.md word by word in a fresh clone, as a newcomer does: ``python -m tools.newcomer [--ready]``.

Each ``sh`` block of the page is run in a terminal of its own, in order; the ``text`` block after it, if there is one, is what
it has to print (``…``: anything). A question is asked again until its answer is that. Only ports are others: 8080 and those of
the simulated machines become ones that nobody uses. At the end everything is ended by Ctrl-C, and has to end well.
"""

import argparse
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import venv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

ROOT = Path(__file__).parents[1]
PORT = "8080"
BLOCK = re.compile(r"^```(sh|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PATIENCE, SET_UP = 120.0, 900.0
"""Seconds for a step to print what it should, and for the one that sets up. Our choice."""
BREATH, LEAVING = 0.5, 30.0
"""Seconds between two questions, and for a command to end after Ctrl-C. Our choice."""
SHOWN = 4
"""Lines that are shown of what a command has printed. Our choice."""


class Astray(Exception):
    """The page led a newcomer somewhere else than it says."""


@dataclass(frozen=True, slots=True)
class Step:
    """A command of the page and what it says that it prints; None: nothing is said."""

    command: str
    prints: str | None

    @property
    def is_question(self) -> bool:
        """Whether it may be asked again: it changes nothing."""
        return self.command.startswith("curl ") and not re.search(r" -(X|d)\b", self.command)

    def printed(self, told: str) -> bool:
        """Whether what was told has what the page says, from the beginning of a line on."""
        if self.prints is None:
            return False
        return re.search(pattern(self.prints), told, re.MULTILINE | re.DOTALL) is not None


def pattern(text: str) -> str:
    """Return the expression for a block of the page, ``…`` standing for anything, also nothing."""
    return "^" + ".*?".join(re.escape(part) for part in re.split(r"\n?…\n?", text.strip()))


def steps(page: str) -> list[Step]:
    """Return the commands of a page in order. Raises Astray: a ``text`` block follows no command."""
    found: list[Step] = []
    for kind, text in BLOCK.findall(page):
        if kind == "sh":
            found.append(Step(text.strip(), None))
        elif found and found[-1].prints is None:
            found[-1] = Step(found[-1].command, text.strip())
        else:
            raise Astray(f"no command prints this:\n{text}")
    return found


def free_ports() -> Iterator[int]:
    """Give ports that nobody uses, below those that Linux gives to outgoing connections."""
    for port in range(18_000 + os.getpid() * 89 % 10_000, 32_000):
        try:
            socket.create_server(("127.0.0.1", port)).close()
        except OSError:
            continue
        yield port


class Terminal:
    """A command under way in a directory, and what it prints."""

    def __init__(self, command: str, directory: Path, environment: Mapping[str, str]) -> None:
        self.command = command
        self._out, self._err = tempfile.TemporaryFile(), tempfile.TemporaryFile()  # noqa: SIM115
        self._process = subprocess.Popen(
            ["bash", "-c", command],
            cwd=directory, env=environment, stdin=subprocess.DEVNULL, stdout=self._out, stderr=self._err,
            start_new_session=True,
        )  # fmt: skip

    @property
    def code(self) -> int | None:
        """How it ended; None: it goes on."""
        return self._process.poll()

    def printed(self, *, errors: bool = False) -> str:
        """Return what it has printed so far; with ``errors`` all that a person sees."""
        return "".join(_text(file) for file in ((self._out, self._err) if errors else (self._out,)))

    def interrupt(self) -> None:
        """Press Ctrl-C. Raises Astray: it does not end, or not well."""
        if self.code is None:
            os.killpg(self._process.pid, signal.SIGINT)
        try:
            self._process.wait(LEAVING)
        except subprocess.TimeoutExpired:
            raise Astray(f"{self.command} goes on after Ctrl-C") from None
        if "Traceback" in self.printed(errors=True):
            raise Astray(f"{self.command} does not end well:\n{self.printed(errors=True)[-3000:]}")

    def kill(self) -> None:
        """End it whatever it does."""
        if self.code is None:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()


class Newcomer:
    """Somebody in a directory, with a terminal for each command that does not end."""

    def __init__(self, directory: Path, port: int) -> None:
        self.directory, self.port = directory, str(port)
        self._terminals: list[Terminal] = []

    def own(self, text: str) -> str:
        """Return a text of the page with our port."""
        return re.sub(rf"\b{PORT}\b", self.port, text)

    def take(self, step: Step) -> None:
        """Do a step. Raises Astray: it does not print what it should, or fails."""
        step = Step(self.own(step.command), None if step.prints is None else self.own(step.prints))
        print(f"$ {step.command}", flush=True)
        end = time.monotonic() + (PATIENCE if (self.directory / ".venv/.ready").exists() else SET_UP)
        while not self._tried(step, end):
            if not step.is_question or time.monotonic() > end:
                seen = self._terminals[-1].printed(errors=True)[-3000:]
                raise Astray(f"{step.command}\nshould print\n{step.prints}\nbut prints\n{seen}")
            time.sleep(BREATH)
        lines = self._terminals[-1].printed().splitlines()
        print("\n".join(line[:200] for line in lines[-SHOWN:]), flush=True)

    def leave(self) -> None:
        """Press Ctrl-C in every terminal, the last first. Raises Astray: one does not end well."""
        while self._terminals:
            self._terminals[-1].interrupt()
            self._terminals.pop()

    def vanish(self) -> None:
        """End whatever is left."""
        for terminal in self._terminals:
            terminal.kill()

    def _tried(self, step: Step, end: float) -> bool:
        """Run a command until it has printed what it should, or has ended; return whether it did well."""
        environment = {**_bare(), "PORT": self.port, "PYTHONUNBUFFERED": "1"}
        terminal = Terminal(step.command, self.directory, environment)
        self._terminals.append(terminal)
        while terminal.code is None and not step.printed(terminal.printed()) and time.monotonic() < end:
            time.sleep(0.1)
        return step.printed(terminal.printed()) or (step.prints is None and terminal.code == 0)


def _text(file: IO[bytes]) -> str:
    return os.pread(file.fileno(), 1 << 22, 0).decode(errors="replace")


def _bare() -> dict[str, str]:
    """Return the environment of somebody who has set nothing for Hoistway, and speaks English."""
    ours = ("HOISTWAY_", "VIRTUAL_ENV", "PYTHONPATH", "LC_", "LANG", "MAKE", "MFLAGS")
    return {name: value for name, value in os.environ.items() if not name.startswith(ours)} | {"LC_ALL": "C.UTF-8"}


def clone(directory: Path, ports: Iterator[int]) -> None:
    """Clone what is committed, with simulated machines at these ports."""
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(directory)], check=True)
    plant = directory / "plants/demo.yaml"
    text = plant.read_text(encoding="utf-8")
    plant.write_text(re.sub(r"\b127\.0\.0\.1:\d+", lambda _: f"127.0.0.1:{next(ports)}", text), encoding="utf-8")


def borrow(directory: Path) -> None:
    """Give the clone a .venv of its own that finds the packages of the one that runs this; only Hoistway is installed anew."""
    venv.create(directory / ".venv", with_pip=True)
    python = str(directory / ".venv/bin/python")
    (site,) = (directory / ".venv/lib").glob("python*/site-packages")
    (given,) = (Path(sys.prefix) / "lib").glob("python*/site-packages")
    (site / "borrowed.pth").write_text(f"{given}\n", encoding="utf-8")
    pip = [
        python,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "--no-deps",
        "--no-build-isolation",
    ]
    subprocess.run([*pip, "--editable", "."], cwd=directory, check=True)
    (directory / ".venv/.ready").touch()


def follow(page: Path, *, ready: bool) -> None:
    """Follow a page in a fresh clone. Raises Astray."""
    with tempfile.TemporaryDirectory(prefix="hoistway-newcomer-") as scratch:
        directory, ports = Path(scratch) / "hoistway", free_ports()
        clone(directory, ports)
        if ready:
            borrow(directory)
        began = time.monotonic()
        newcomer = Newcomer(directory, next(ports))
        try:
            for step in steps((directory / page).read_text(encoding="utf-8")):
                newcomer.take(step)
            newcomer.leave()
        finally:
            newcomer.vanish()
        print(f"{page}: all of it went as it says, in {time.monotonic() - began:.0f} s")


def main(arguments: Sequence[str] | None = None) -> int:
    """Follow README.md; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--ready", action="store_true", help="do not set up from bare Python: borrow this one's packages"
    )
    try:
        follow(Path("README.md"), ready=parser.parse_args(arguments).ready)
    except Astray as astray:
        print(f"newcomer: {astray}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    # What is started where Ctrl-C is ignored, as a job in the background of a script is, would ignore it for ever.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    sys.exit(main())
