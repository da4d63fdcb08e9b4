"""One catalogue for page, API and command line: whole in both languages."""

import ast
import json
import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from itertools import count
from pathlib import Path

import pytest
import yaml

from app.api.problems import CODES, USUAL
from app.domain import device_requests, drive_requests, requests, teaching_requests
from app.domain.job import JobEvent
from app.texts import LANGUAGES, catalogue, language_of, text, told

REQUESTS = (requests, teaching_requests, drive_requests, device_requests)
CLAUSES = re.compile(r"\{\d\}|[;:,.()]")
"""Sentences are put together at such places."""
APP = Path(__file__).parents[1] / "app"
SLOT = re.compile(r"\{\d\}")


def test_both_languages_have_the_same_sections_and_keys() -> None:
    english, korean = (catalogue(language) for language in LANGUAGES)
    assert {section: set(words) for section, words in english.items()} == {
        section: set(words) for section, words in korean.items()
    }


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_word_is_written_twice_of_which_only_the_last_would_be_said(language: str) -> None:
    def once(pairs: list[tuple[str, object]]) -> dict[str, object]:
        names = [name for name, _ in pairs]
        assert sorted(set(names)) == sorted(names), sorted(name for name in names if names.count(name) > 1)
        return dict(pairs)

    json.loads((APP / "texts" / f"{language}.json").read_text(encoding="utf-8"), object_pairs_hook=once)


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


OF_PYDANTIC = re.compile(r"Input should |String should |unable to parse ")
RUNS = 3
"""A clause that is put together from words stands in the code in so many pieces at most."""


def runs_in(clause: str, code: str) -> int:
    """Return in how many runs of words a clause stands in the code, taken as long as they go."""
    words, runs = clause.split(), 0
    while words:
        end = next((n for n in range(len(words), 0, -1) if " ".join(words[:n]) in code), 0)
        if not end:
            return RUNS + 1
        words, runs = words[end:], runs + 1
    return runs


def test_every_event_has_its_words() -> None:
    assert {str(event) for event in JobEvent} <= set(catalogue("en")["events"])


def _constants() -> str:
    """Return all text that the program's code has, without what is filled in."""
    found: list[str] = []
    for file in APP.rglob("*.py"):
        nodes = ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        found += [node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    page = (APP.parent / "web" / "src").rglob("*.ts*")
    return "\n".join([*found, *(file.read_text(encoding="utf-8") for file in page)])


def test_everything_that_can_be_asked_for_has_its_words_in_the_audit() -> None:
    classes = [cls for module in REQUESTS for cls in vars(module).values() if isinstance(cls, type)]
    ours = [cls for cls in classes if "requests" in cls.__module__ and is_dataclass(cls)]
    asked = {cls.__name__ for cls in ours if "actor" in {one.name for one in fields(cls)}}
    assert "CreateJob" in asked
    assert {f"did_{name}" for name in asked} <= set(catalogue("en")["page"])


def test_every_saying_is_still_said_somewhere() -> None:
    code = " ".join(_constants().split())
    unsaid = {
        key: clause
        for key, sentence in catalogue("en")["sayings"].items()
        for clause in CLAUSES.split(sentence)
        if len(clause.strip()) > 9 and not OF_PYDANTIC.search(clause) and " or " not in clause
        if runs_in(clause, code) > RUNS
    }
    assert not unsaid, "the code says this otherwise now: change or drop the saying"


CALL = re.compile(r"/api/v1|\b(?:GET|POST|PUT|PATCH|DELETE) |\bverdict \w")
QUOTED = re.compile(r"‘([^’]+)’")
KEPT = re.compile(r"^vehicle \{0\}, verdict ")
"""A row of the audit says what was asked for, and nothing that would help."""


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_call_that_a_saying_names_has_its_button_or_room_on_the_page(language: str) -> None:
    words = catalogue("ko" if language == "ko" else "en")
    named = {
        key for key, saying in catalogue("en")["sayings"].items() if CALL.search(saying) and not KEPT.search(saying)
    }
    assert len(named) > 40
    assert named - set(words["pages"]) == set(), "say in the section pages which button or room that is"
    assert {
        key for key, instead in words["pages"].items() if CALL.search(re.sub(r"/api/v1/\{0\}", "", instead))
    } == set()


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_the_page_says_instead_names_buttons_that_there_are_and_fills_in_no_more(language: str) -> None:
    words = catalogue("ko" if language == "ko" else "en")
    there = set(words["page"].values())
    sayings = catalogue("en")["sayings"]
    for key, instead in words["pages"].items():
        assert set(QUOTED.findall(instead)) <= there, key
        assert set(SLOT.findall(instead)) <= set(SLOT.findall(sayings[key])), key


BY_WORD = frozenset(
    {
        "X0 stands for another order already: job X1.",
        "there is no X0",
        "X0 is kept X1: X2",
        "X0 is kept X1 by X2: X3",
        "X0 is kept X1 by X2",
        "X0: it has a raw value alone",
        "X0: nobody says what it may be",
        "X0 is of X1, X2 is X3",
        "job X0 is X1",
        "There is a X0 X1 already.",
        "That is version X0 (X1), to the letter.",
        "Version X0 is X1.",
    }
)
"""What is filled in decides on the Korean: the catalogue has them word by word (open, closed; user, key; …)."""


def _template(node: ast.expr) -> str:
    """Return a literal sentence with X0, X1 … for what is filled in; empty: it is none."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = _template(node.left), _template(node.right)
        return left + right if left and right else ""
    if not isinstance(node, ast.JoinedStr):
        return ""
    slots = count()
    parts = (part.value if isinstance(part, ast.Constant) else f"X{next(slots)}" for part in node.values)
    return "".join(map(str, parts))


def _refusals() -> Iterator[tuple[str, str]]:
    """Give every literal sentence of a refusal, a problem or a hold in the code, with where it stands."""
    files = (file for file in APP.rglob("*.py") if not {"cli", "sim"} & set(file.parts))
    for file in files:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) in {"Refusal", "Problem", "Hold"}:
                for argument in (*node.args, *(keyword.value for keyword in node.keywords)):
                    sentence = _template(argument)
                    if " " in sentence and len(re.findall("[a-z]{2,}", sentence)) > 1:
                        yield f"{file.relative_to(APP)}:{node.lineno}", sentence


def test_every_refusal_in_the_code_has_its_korean() -> None:
    found = list(_refusals())
    assert len(found) > 400
    english = {place: said for place, said in found if told(said, "ko") == said and said not in BY_WORD}
    assert not english, "add a saying to app/texts (en.json and ko.json)"


@pytest.mark.parametrize(
    ("sentence", "korean"),
    [
        (
            "V012 waits at 1203 for 1204 held by V007, which is picking up at STK01-P02 (8 s)",
            "1203의 V012: STK01-P02에서 적재 중인 V007(8초) 점유 1204 대기",
        ),
        ("V012 waits at 1203: everything is stopped by Kim", "1203의 V012: Kim 님이 전체 정지"),
        (
            "no vehicle is free: V001 is on job J7, and V002 is not ready",
            "가용 차량 없음: V001 작업 J7 수행 중, V002 is not ready",
        ),
        ("P2 is occupied by F7", "P2에 F7이 있음"),
        ("does HW-2", "HW-2 수행 중"),
        (
            "not connected yet; look where it stands; release it with verdict go_on if the barcode is right",
            "아직 연결되지 않음; 위치를 확인하고 바코드가 맞으면 '보고가 맞음'으로 해제하세요",
        ),
    ],
)
def test_what_the_controller_says_is_told_in_korean(sentence: str, korean: str) -> None:
    assert told(sentence, "ko") == korean
    assert told(sentence, "en") == sentence


def test_a_sentence_that_the_catalogue_does_not_know_is_shown_as_it_is() -> None:
    assert told("nobody ever said this about V001", "ko") == "nobody ever said this about V001"
    assert told("", "ko") == ""


def _names() -> set[str]:
    """Return the names that come with the product: of parameters, and of what the example plants have."""
    found: set[str] = set()
    for file in (APP / "catalogues").glob("*.yaml"):
        described = yaml.safe_load(file.read_text(encoding="utf-8"))
        found.add(described.get("description", ""))
        for parameter in described["parameters"].values():
            choices = (str(word) for word in parameter.get("choices", {}).values())
            words = (word for word in choices if not word[0].isdigit())
            found |= {parameter["name"], parameter.get("description", ""), *words}
    for file in (APP.parent / "plants").glob("*.yaml"):
        plant = yaml.safe_load(file.read_text(encoding="utf-8"))
        for kind in ("zones", "drives"):
            found |= {one.get("name", "") for one in plant.get(kind, {}).values()}
    return found - {""}


def test_names_that_come_with_the_product_have_their_korean_and_no_others_are_kept() -> None:
    names = _names()
    assert {"Acceleration time", "Way into bay A", "Lift of stocker STK01"} <= names
    assert set(catalogue("en")["names"].values()) == names
    assert {name for name in names if not re.search("[가-힣]", told(name, "ko"))} == set()


def test_a_name_is_told_by_itself_and_within_a_sentence_and_an_owners_stays() -> None:
    assert told("Acceleration time", "ko") == "가속 시간"
    assert told("parameter 1C (Step 0 position) is read-only", "ko") == "파라미터 1C (스텝 0 위치): 읽기 전용"
    assert told("Acceleration time", "en") == "Acceleration time"
    assert told("Our own lift", "ko") == "Our own lift"
