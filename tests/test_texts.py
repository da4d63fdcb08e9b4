"""One catalogue for page, API and command line: whole in both languages."""

import re

import pytest

from app.api.problems import CODES, USUAL
from app.texts import LANGUAGES, catalogue, language_of, text, told

SLOT = re.compile(r"\{\d\}")


def test_both_languages_have_the_same_sections_and_keys() -> None:
    english, korean = (catalogue(language) for language in LANGUAGES)
    assert {section: set(words) for section, words in english.items()} == {
        section: set(words) for section, words in korean.items()
    }


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_left_empty_and_every_slot_is_filled_in_both_languages(language: str) -> None:
    for section, words in catalogue("en").items():
        for key, sentence in words.items():
            other = catalogue("ko" if language == "ko" else "en")[section][key]
            assert other.strip(), f"{section}.{key}"
            assert sorted(set(SLOT.findall(other))) == sorted(set(SLOT.findall(sentence))), f"{section}.{key}"


def test_every_code_of_a_problem_has_a_title_and_every_usual_remedy_its_words() -> None:
    assert set(catalogue("en")["problems"]) == set(CODES)
    assert {code: text("problems", code) for code in CODES} == {code: title for code, (_, title) in CODES.items()}
    assert set(catalogue("en")["remedies"]) == {*USUAL, "other"}


@pytest.mark.parametrize(
    ("accepted", "language"),
    [
        ("", "en"),
        ("ko-KR,ko;q=0.9,en;q=0.8", "ko"),
        ("en;q=0.5, ko;q=0.9", "ko"),
        ("fr, de;q=0.9, ko;q=0.1", "ko"),
        ("ko;q=0, en", "en"),
        ("ko_KR.UTF-8", "ko"),
        ("C.UTF-8", "en"),
        ("*;q=x,,;", "en"),
    ],
)
def test_the_language_is_the_one_that_the_caller_prefers_of_ours(accepted: str, language: str) -> None:
    assert language_of(accepted) == language


def test_a_sentence_that_the_catalogue_does_not_know_is_shown_as_it_is() -> None:
    assert told("nobody ever said this about V001", "ko") == "nobody ever said this about V001"
    assert told("", "ko") == ""
