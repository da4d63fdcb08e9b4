"""The words of the field: what the glossary sends a reader to is there, and its Korean part has no word of its own."""

import re
from pathlib import Path

from app.api.policy import ROUTES

PAGE = (Path(__file__).parents[1] / "docs" / "glossary.md").read_text(encoding="utf-8")
ENGLISH, KOREAN = PAGE.split("\n## In Korean\n")
CALL = re.compile(r"`(GET|POST|PUT|DELETE) /api/v1(/[^`?]*)`")


def rows(part: str) -> list[list[str]]:
    found = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in part.splitlines() if line.startswith("| ")
    ]
    return [row for row in found if row[0] not in {"word", "낱말"}]


def test_every_call_that_it_names_is_one_of_the_api() -> None:
    routes = {re.sub(r"\{\w+\}", "ID", route) for route in ROUTES}
    calls = [f"{method} {path}" for method, path in CALL.findall(PAGE)]
    assert len(calls) > 15
    assert [call for call in calls if call not in routes] == []


def test_every_word_is_told_in_a_few_words_with_where_it_is_at_work() -> None:
    for row in (*rows(ENGLISH), *rows(KOREAN)):
        assert all(row), row
        assert len(row[-2]) < 230, row
    words = [row[0] for row in rows(ENGLISH)]
    assert len(set(words)) == len(words) > 45


def test_what_the_korean_part_tells_the_english_part_has_too() -> None:
    told = " ".join(cell for row in rows(ENGLISH) for cell in row[:2])
    for word, *_ in rows(KOREAN):
        for part in re.split(r"[,(): ]+", word.replace("버전: ", "")):
            assert part in told, word
