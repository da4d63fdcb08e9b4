"""The command line in Korean: everything that it explains and says is in the catalogue, in both languages."""

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest
import typer
from typer.testing import CliRunner

from app.cli import app
from app.cli.tongue import wished
from app.setting_words import described
from app.settings import Settings
from app.texts import COUNT, LANGUAGES, language_of, said, terminal
from tests.test_texts import RUNS, runs_in

ROOT = Path(__file__).parents[2]
SLOT = re.compile(r"\{\d\}")
SAYERS = {
    *("say", "refuse", "_refuse", "CannotStart", "told_here", "_done", "BadParameter"),
    *("well", "doubtful", "wrong", "counted_here"),
}
"""What takes sentences that a person reads in a terminal."""
FRAME = {
    *("Usage:", "Options", "Arguments", "Commands", "default", "required", "env var", "[OPTIONS]", "COMMAND [ARGS]..."),
    "Show this message and exit.",
    "No such option: {0}",
    "No such option: {0} (Possible options: {1})",
    "No such option: {0} Did you mean {1}?",
    "No such command '{0}'.",
    "No such command '{0}'. Did you mean {1}?",
    "Missing command.",
    "Missing option '{0}'.",
    "Missing argument '{0}'.",
    "Invalid value for '{0}': {1}",
    "Got unexpected extra argument(s) ({0})",
    "Input should be a valid integer, unable to parse string as an integer",
    "Input should be a valid number, unable to parse string as a number",
    "Input should be a valid boolean, unable to interpret input",
    "Input should be a finite number",
    "Input should be greater than {0}",
    "Input should be greater than or equal to {0}",
    "Input should be less than {0}",
    "Input should be less than or equal to {0}",
    "Value error, {0} is not one of {1}.",
    "Option '{0}' requires an argument.",
    "Option '{0}' does not take a value.",
}
"""What the library says that reads the command line."""


SYSTEM = {
    *map(os.strerror, range(1, 134)),
    *("Name or service not known", "Temporary failure in name resolution"),
    *("unable to open database file", "attempt to write a readonly database", "database is locked"),
    *("file is not a database", "database disk image is malformed", "database or disk is full"),
}
"""What the operating system and SQLite say of files and connections."""


def hoistway(*arguments: str, **env: str) -> subprocess.CompletedProcess[str]:
    bare = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG", "HOISTWAY_"))}
    return subprocess.run(
        [sys.executable, "-m", "app.main", *arguments],
        cwd=ROOT, env={**bare, "PYTHONUTF8": "1", **env}, capture_output=True, text=True, timeout=100, check=False,
    )  # fmt: skip


def explanations() -> Iterator[str]:
    """Give every explanation of every command and option, paragraph by paragraph."""

    def of(command: Any) -> Iterator[str]:
        yield from (command.help or "").split("\n\n")
        for parameter in command.params:
            yield getattr(parameter, "help", None) or ""
        for inner in getattr(command, "commands", {}).values():
            yield from of(inner)

    yield from filter(None, (" ".join(text.split()) for text in of(typer.main.get_command(app))))


def messages() -> Iterator[tuple[str, str]]:
    """Give every sentence that the code of the command line says, as a pattern, with the file that says it."""
    for file in sorted((ROOT / "app/cli").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and (name := called(node)) in SAYERS:
                for argument in [*node.args, *(word.value for word in node.keywords)]:
                    for line in (text for whole in patterns(argument) for text in whole.splitlines()):
                        if re.search(r"[A-Za-z]{2}", SLOT.sub("", line)):
                            yield f"{COUNT} {line}" if name == "counted_here" else line, file.name


def called(node: ast.Call) -> str:
    return str(getattr(node.func, "id", getattr(node.func, "attr", "")))


def patterns(node: ast.expr) -> Iterator[str]:
    """Give what an argument may say: both ends of a choice."""
    if isinstance(node, ast.IfExp):
        yield from patterns(node.body)
        yield from patterns(node.orelse)
    elif (text := pattern(node)) is not None:
        yield text


def pattern(node: ast.expr) -> str | None:
    """Return a text with {0}, {1} … for what is filled in; None: it is none."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if not isinstance(node, ast.JoinedStr):
        return None
    parts = iter(range(10))
    return "".join(
        str(piece.value) if isinstance(piece, ast.Constant) else f"{{{next(parts)}}}" for piece in node.values
    )


def test_both_languages_have_the_same_texts_with_the_same_slots() -> None:
    english, korean = (terminal(language) for language in LANGUAGES)
    assert list(english) == list(korean)
    for key, text in english.items():
        assert korean[key].strip(), key
        assert sorted(set(SLOT.findall(korean[key]))) == sorted(set(SLOT.findall(text))), key


def test_no_korean_text_was_left_in_english() -> None:
    english, korean = (terminal(language) for language in LANGUAGES)
    same = {text for key, text in english.items() if korean[key] == text and re.search("[a-z]{3}", SLOT.sub("", text))}
    assert same == {"node-link JSON ({0}), {1}", "GraphML, {0}"}


def test_every_explanation_of_a_command_and_of_an_option_is_in_the_catalogue() -> None:
    known = set(terminal("en").values())
    assert {text for text in explanations() if text not in known} == set()


def test_every_message_of_the_command_line_is_in_the_catalogue() -> None:
    known = {SLOT.sub("{}", text) for text in terminal("en").values()}
    assert {(text, file) for text, file in messages() if SLOT.sub("{}", text) not in known} == set()


def test_every_text_of_the_catalogue_is_still_said() -> None:
    code = "\n".join(file.read_text(encoding="utf-8") for file in (ROOT / "app").rglob("*.py"))
    told = {*explanations(), *(text for text, _ in messages()), *FRAME, *SYSTEM}
    told |= set(described(Settings).values())
    for text in set(terminal("en").values()) - told:
        pieces = [piece.strip(" .:") for piece in re.split(r"\{\d\}|[;:,]", text)]
        assert all(runs_in(piece, code) <= RUNS for piece in pieces if len(piece) > 3), text


@pytest.mark.parametrize(
    ("arguments", "environ", "language"),
    [
        (["--lang", "ko", "check"], {"HOISTWAY_LANG": "en"}, "ko"),
        (["--lang=ko"], {}, "ko"),
        (["decode", "--lang", "ko"], {}, "en"),
        (["check"], {"HOISTWAY_LANG": "ko", "LC_ALL": "en_US.UTF-8"}, "ko"),
        ([], {"LC_ALL": "ko_KR.UTF-8", "LANG": "en_US.UTF-8"}, "ko"),
        ([], {"LC_ALL": "", "LANG": "ko_KR.UTF-8"}, "ko"),
        ([], {"LC_ALL": "C", "LANG": "ko_KR.UTF-8"}, "en"),
        ([], {}, "en"),
    ],
)
def test_the_option_goes_before_the_variable_and_that_before_the_locale(
    arguments: list[str], environ: Mapping[str, str], language: str
) -> None:
    assert language_of(wished(arguments, environ)) == language


def test_help_is_korean_from_its_head_to_its_remarks() -> None:
    told = hoistway("--lang", "ko", "demo", "--help")
    assert told.returncode == 0
    assert told.stdout.startswith("사용법: hoistway demo [옵션]")
    assert re.search(r"--port <int> +기다릴 포트 +\[기본값: 8080\]", told.stdout)
    words = re.findall(r"[A-Za-z]{3,}", re.sub(r"<\w+[^>]*>|--[\w-]+|plants/\S+|\[기본값[^\]]*\]", "", told.stdout))
    assert set(words) <= {"hoistway", "demo", "Ctrl", "SQLAlchemy", "URL", "workload"}


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["serv"], 2, ("오류: 'serv'라는 명령은 없습니다.", "도움말: 'hoistway --help'.")),
        (["serve", "--prot", "1"], 2, ("그런 옵션은 없습니다: --prot",)),
        (["users", "add"], 2, ("인수 'name'이(가) 필요합니다.",)),
        (["serve"], 1, ("hoistway: 어느 플랜트입니까? --plant 파일을 쓰거나 HOISTWAY_PLANT를 정하십시오.",)),
        (["serve", "--plant", "no.yaml"], 1, ("no.yaml을 읽을 수 없습니다",)),
        (["decode", "itsc", "zz"], 2, ("1번째 'z'는 16진수 숫자가 아님",)),
        (
            ["layout", "import", "a", "--format", "x"],
            2,
            ("'x'는 쓸 수 있는 값이 아닙니다. 쓸 수 있는 값: 'csv', 'xlsx'",),
        ),
        (["fuzz", "--jobs", "0"], 2, ("'--jobs'의 값이 잘못되었습니다: 1 이상이어야 합니다",)),
        (["workload", "--keep", "few"], 2, ("정수여야 합니다",)),
        (["serve", "--plant"], 2, ("옵션 '--plant'에 값이 필요합니다.",)),
        (["serve", "--port", "99999"], 1, ("설정 port: 99999는 65535 이하가 아님",)),
    ],
)
def test_what_is_wrong_is_told_in_korean_with_the_usual_exit_code(
    arguments: list[str], code: int, words: Sequence[str]
) -> None:
    told, english = hoistway(*arguments, LANG="ko_KR.UTF-8"), hoistway(*arguments)
    assert (told.returncode, english.returncode) == (code, code)
    assert "Traceback" not in told.stderr
    for word in words:
        assert word in told.stderr
        assert word not in english.stderr


def test_a_language_that_there_is_not_is_refused() -> None:
    told = hoistway("--lang", "xx", "check")
    assert told.returncode == 2
    assert "xx is no language that Hoistway speaks: en, ko" in told.stderr


def test_a_sentence_with_something_filled_in_is_told_in_korean_and_an_unknown_one_as_it_is() -> None:
    assert said("hoistway controls demo: http://127.0.0.1:8080", "ko") == (
        "hoistway가 demo를 제어합니다: http://127.0.0.1:8080"
    )
    assert said("nobody ever said this", "ko") == "nobody ever said this"
    assert said("hoistway controls demo: http://127.0.0.1:8080", "en").startswith("hoistway controls")


def test_what_is_wrong_with_a_layout_is_told_in_korean(tmp_path: Path) -> None:
    plant = (ROOT / "plants/small.yaml").read_text(encoding="utf-8").replace("at: 104", "at: 999", 1)
    (tmp_path / "wrong.yaml").write_text(plant, encoding="utf-8")
    told = hoistway("--lang", "ko", "check", str(tmp_path / "wrong.yaml"))
    assert told.returncode == 1
    assert "오류: 알 수 없는 바코드 999" in told.stdout
    assert "barcodes 아래에 쓰세요" in told.stdout


TERMS = {
    *(
        "hoistway",
        "check",
        "layout",
        "bench",
        "yaml",
        "csv",
        "lif",
        "json",
        "demo",
        "small",
        "fab",
        "clearance",
        "dest",
    ),
    *(
        "CSV",
        "UTF",
        "JSON",
        "AGV",
        "DEST",
        "OFFSET",
        "ETX",
        "STX",
        "ETB",
        "CRC",
        "BCC",
        "LEN",
        "NTP",
        "Python",
        "Linux",
    ),
    *(
        "SQLAlchemy",
        "sqlite",
        "pysqlite",
        "GB",
        "ms",
        "mm",
        "km",
        "vehicles",
        "parking",
        "barcodes",
        "length",
        "dialect",
    ),
    *("traffic", "idle", "listen", "docs", "teaching", "md", "sbfl", "sbfr", "port", "agv", "buffer", "charger"),
    *("unit", "up", "plant", "dev", "id", "address", "curl", "GET", "PUT", "api", "HOISTWAY"),
}
"""Names of files, fields, options and figures, which have no Korean."""
LIST = "barcode,x,y,next,station,kind,비고\n1,0,0,2,P1,port,\n2,1000,0,3,,,\n3,2000,inf,1,P2,gate,\n4,5000,0,1,P3,,\n"


def in_korean(*arguments: str) -> str:
    """Return what a command says in Korean, within this process."""
    return CliRunner(env={"HOISTWAY_LANG": "ko"}).invoke(app, arguments).output


def english_in(said: str, file: Path) -> set[str]:
    """Return the English words that are left, but for names."""
    said = re.sub(rf"{re.escape(str(file.parent))}\S*|plants/\S+|--[\w-]+|'[^']*'", "", said)
    return set(re.findall(r"[A-Za-z]{2,}", re.sub(r"\b[A-Z]+\d[\w-]*|\b[0-9a-f]{64}\b", "", said))) - TERMS


@pytest.mark.parametrize(
    "arguments",
    [
        ("check", "plants/demo.yaml"),
        ("layout", "check", "plants/demo.yaml"),
        ("layout", "diff", "plants/demo.yaml", "plants/demo.yaml"),
        ("layout", "import", "{}/list.csv", "-o", "{}/plant.yaml"),
        ("layout", "import", "{}/nothing.csv"),
        ("layout", "export", "plants/demo.yaml", "-o", "{}/demo.lif"),
        ("layout", "render", "plants/small.yaml", "-o", "{}/small.svg"),
        ("fab", "--size", "1k", "--statistics"),
        ("fab", "--size", "2k"),
        ("schema", "fab"),
        ("decode", "itsc", "0210"),
        ("decode", "hi", "0210"),
        ("decode", "enig", "0210"),
        ("decode", "itsc", "0x1"),
        ("detect", "itsc", "{}/list.csv"),
        ("simulate", "--plant", "plants/small.yaml", "--hours", "0.01"),
        ("db", "current", "--url", "sqlite:///{}/no/plant.db"),
        ("users", "add", "a/b", "--role", "admin", "--database", "sqlite:///{}/plant.db"),
    ],
    ids=" ".join,
)
def test_a_command_says_nothing_in_english_but_names(arguments: Sequence[str], tmp_path: Path) -> None:
    (tmp_path / "list.csv").write_text(LIST, encoding="utf-8")
    said = in_korean(*(argument.replace("{}", str(tmp_path)) for argument in arguments))
    assert re.search("[가-힣]", said), said
    assert english_in(said, tmp_path / "list.csv") == set(), said


def test_the_doctor_says_in_korean_what_it_found(tmp_path: Path) -> None:
    said = in_korean("doctor", "--plant", "plants/small.yaml", "--database", f"sqlite:///{tmp_path}/plant.db")
    assert english_in(said, tmp_path / "plant.db") - {"Darwin", "aarch", "arm"} == set(), said


def test_one_thing_is_counted_as_several_are() -> None:
    assert said("1 door", "ko") == "도어 1개"
    assert said("2 doors", "ko") == "도어 2개"
    assert said("buffer and alias of 1 station", "ko") == "스테이션 1개의 버퍼와 별칭"
