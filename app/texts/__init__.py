"""The words for people, in each language, from one catalogue: page, API and command line speak from it.

``en.json`` and ``ko.json`` have the same sections and keys. ``page`` are words and sentences with ``{0}``, ``{1}`` … for what is
filled in; ``problems`` and ``remedies`` go by the code of a problem, ``events`` by their names. ``sayings`` are the patterns
of sentences that the controller says and keeps in English: they are translated where they are shown (:func:`told`),
since what is kept in a plant's database does not depend on who reads it.
"""

import json
import re
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Literal, get_args

Language = Literal["en", "ko"]
Section = Literal["page", "problems", "remedies", "sayings", "events"]
LANGUAGES: tuple[Language, ...] = get_args(Language)
HERE = Path(__file__).parent
_SLOT = re.compile(r"(\{\d\})")
_DEPTH = 4
"""Sentences within sentences are translated too, so deep."""


@lru_cache
def catalogue(language: Language) -> Mapping[Section, Mapping[str, str]]:
    """Return all that there is to say in a language, by section and key."""
    found: Mapping[Section, Mapping[str, str]] = json.loads((HERE / f"{language}.json").read_text(encoding="utf-8"))
    return found


def text(section: Section, key: str, language: Language = "en", *values: object) -> str:
    """Return a word or sentence with its slots filled. Raises KeyError: the catalogue has none of that key."""
    sentence = catalogue(language)[section][key]
    for number, value in enumerate(values):
        sentence = sentence.replace(f"{{{number}}}", str(value))
    return sentence


def language_of(accepted: str) -> Language:
    """Return the language that an Accept-Language header, or a locale such as ``ko_KR.UTF-8``, prefers; else English."""
    wishes: list[tuple[float, int, str]] = []
    for place, part in enumerate(accepted.split(",")):
        name, _, more = part.strip().partition(";")
        weight = re.fullmatch(r"\s*q=([01](?:\.\d{0,3})?)\s*", more) if more else None
        wishes.append((-float(weight[1]) if weight else -1.0, place, re.split(r"[-_.@]", name.lower())[0]))
    known = [name for weight, _, name in sorted(wishes) if name in LANGUAGES and weight < 0]
    return "ko" if known[:1] == ["ko"] else "en"


def told(sentence: str, language: Language) -> str:
    """Return a sentence of the controller in a language, as far as the catalogue has its pattern; else as it is."""
    return sentence if language == "en" or not sentence else _retold(sentence, language, _DEPTH)


@lru_cache(maxsize=4096)
def _retold(sentence: str, language: Language, depth: int) -> str:
    for pattern, other in _patterns(language):
        if match := pattern.fullmatch(sentence):
            return _filled(other, match.groupdict(), language, depth)
    return sentence


def _filled(other: str, parts: Mapping[str, str], language: Language, depth: int) -> str:
    def part(slot: re.Match[str]) -> str:
        found = parts.get(f"s{slot[0][1]}", slot[0])
        return _retold(found, language, depth - 1) if depth and " " in found else found

    return _SLOT.sub(part, other)


@lru_cache
def _patterns(language: Language) -> list[tuple[re.Pattern[str], str]]:
    """Return patterns with what they mean, those with most letters of their own first."""
    other = catalogue(language)["sayings"]
    rows = sorted(catalogue("en")["sayings"].items(), key=lambda row: -len(_SLOT.sub("", row[1])))
    return [(re.compile(_pattern(sentence), re.DOTALL), other[key]) for key, sentence in rows]


def _pattern(sentence: str) -> str:
    """Return it as an expression. What stands first is a name, or several: a clause within a sentence is none by itself."""
    first, *rest = (part for part in _SLOT.split(sentence) if part)
    head = rf"(?P<s{first[1]}>\S+?(?:, \S+?)*?)" if _SLOT.fullmatch(first) else re.escape(first)
    return head + "".join(f"(?P<s{part[1]}>.+?)" if _SLOT.fullmatch(part) else re.escape(part) for part in rest)
