"""The two READMEs lead to the same: the same steps, sections, table rows, commands, links and figures."""

import re
from pathlib import Path

import pytest

from tools.newcomer import Astray, Step, pattern, steps

ROOT = Path(__file__).parents[1]
ENGLISH, KOREAN = ((ROOT / name).read_text(encoding="utf-8") for name in ("README.md", "README.ko.md"))
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)]+)\)")
BENCH = re.compile(r"<!-- (?:make bench|hoistway bench traffic) writes from here -->\n(.*?)<!-- to here -->", re.DOTALL)


def rows(page: str) -> list[str]:
    return [line for line in BENCH.sub("", page).splitlines() if line.startswith("| ")]


def headings(page: str) -> list[int]:
    return [len(mark) for mark in re.findall(r"^(#+) ", re.sub(r"(?ms)^```.*?^```$", "", page), re.MULTILINE)]


def named(text: str) -> tuple[list[str], list[str]]:
    """Return what a piece of a page names: code, without what a Korean reader says in Korean, and links."""
    return sorted(set(CODE.findall(text)) - IN_ENGLISH - IN_KOREAN), sorted(set(LINK.findall(text)))


IN_ENGLISH = {"X-Actor: your name"}
IN_KOREAN = {"X-Actor: 이름(영문)", "examples/layouts/barcodes-ko.csv", "?lang=ko"}
"""What only one of them has for its reader's sake."""


def test_a_newcomer_takes_the_same_steps_in_both_languages_and_ends_with_a_delivered_carrier() -> None:
    assert [step.command for step in steps(KOREAN)] == [step.command for step in steps(ENGLISH)]
    taken = steps(ENGLISH)
    assert taken[0].command == "make run"
    assert any("/carriers/" in step.command and '"place":"' in (step.prints or "") for step in taken)
    assert all(step.prints for step in taken)


def test_both_have_the_same_sections() -> None:
    assert headings(KOREAN) == headings(ENGLISH)


def test_each_row_of_the_tables_names_the_same_commands_paths_and_pages() -> None:
    english, korean = rows(ENGLISH), rows(KOREAN)
    assert len(korean) == len(english)
    for one, other in zip(english, korean, strict=True):
        assert named(other) == named(one), one


def test_each_section_names_the_same_commands_paths_and_pages() -> None:
    english, korean = (re.split(r"(?m)^## ", BENCH.sub("", page)) for page in (ENGLISH, KOREAN))
    for one, other in zip(english, korean, strict=True):
        assert named(other)[0] == named(one)[0], one.partition("\n")[0]


def test_the_figures_are_the_same_in_both() -> None:
    english, korean = BENCH.findall(ENGLISH), BENCH.findall(KOREAN)
    assert len(english) == 2
    assert korean == english


def test_a_block_is_printed_where_its_lines_come_with_anything_between_them_where_it_says_so() -> None:
    step = Step("make run", 'one {"a":1,…"b":2,…\n…\nlast')
    assert step.printed('before\none {"a":1,"c":3,"b":2,"d":4}\nmore\nlast line')
    assert not step.printed('before\none {"a":1,"c":3}\nlast')
    assert not step.printed('x one {"a":1,"b":2,}\nlast')
    assert pattern("a.b") == r"^a\.b"


def test_only_what_changes_nothing_is_asked_again() -> None:
    assert Step("curl http://127.0.0.1:8080/api/v1/jobs/HW-1", "x").is_question
    assert not Step("curl -X POST http://127.0.0.1:8080/api/v1/jobs \\\n  -d '{}'", "x").is_question
    assert not Step("make run", "x").is_question


def test_a_block_that_no_command_prints_is_told() -> None:
    with pytest.raises(Astray, match="no command prints this"):
        steps("```sh\nmake\n```\n\n```text\none\n```\n\n```text\ntwo\n```\n")
