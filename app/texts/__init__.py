"""The words for people, in each language, from one catalogue: page, API and command line speak from it.

``en.json`` and ``ko.json`` have the same sections and keys. ``page`` are words and sentences with ``{0}``, ``{1}`` … for what is
filled in; ``problems`` and ``remedies`` go by the code of a problem, ``events`` by their names. ``sayings`` are the patterns
of sentences that the controller says and keeps in English: they are translated where they are shown (:func:`told`),
since what is kept in a plant's database does not depend on who reads it. ``pages`` has, for sayings that speak of the API
(a call, a word of its bodies), what the page says instead: the name of a button or a room. ``names`` are names that come with
the product, not from a plant's owner: of the parameters in ``app/catalogues``, of zones and drives in ``plants``. They are told
like sentences, by themselves and within one.
A particle after a slot is written 이(가), 을(를),
(으)로 …: the one that fits is chosen when the slot is filled (:mod:`app.texts.particles`).

``terminal.en.json`` and ``terminal.ko.json`` are what the command line says: explanations of commands and options, and messages,
as patterns too (:func:`said`). They lie beside the others, since the page is not built from them.
"""

import json
import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Literal, get_args

from app.texts.particles import settled

Language = Literal["en", "ko"]
Section = Literal["page", "problems", "remedies", "sayings", "pages", "events", "names"]
LANGUAGES: tuple[Language, ...] = get_args(Language)
Patterns = list[tuple[str, re.Pattern[str], str]]
"""The longest fixed part of a sentence (which is looked for first, since it is quick), its pattern, and what it means."""
Tell = Callable[[str, Language, int], str]
"""What tells a sentence within a sentence, so deep."""
HERE = Path(__file__).parent
COUNT = "{9}"
"""The slot for a number: ``{9} stations`` is said of 3 stations, and not of what stands under stations."""
_NUMBER = r"[0-9][0-9,.]*"
_SLOT = re.compile(r"(\{\d\})")
_FIXED = re.compile(r"\{\d\}")
_DEPTH = 4
"""Sentences within sentences are translated too, so deep."""


@lru_cache
def catalogue(language: Language) -> Mapping[Section, Mapping[str, str]]:
    """Return all that there is to say in a language, by section and key."""
    found: Mapping[Section, Mapping[str, str]] = json.loads((HERE / f"{language}.json").read_text(encoding="utf-8"))
    return found


@lru_cache
def terminal(language: Language) -> Mapping[str, str]:
    """Return all that the command line says in a language, by key."""
    found: Mapping[str, str] = json.loads((HERE / f"terminal.{language}.json").read_text(encoding="utf-8"))
    return found


def said(sentence: str, language: Language) -> str:
    """Return what the command line says in a language, as far as its texts, or else the sayings, have it; else as it is."""
    return sentence if language == "en" or not sentence.strip() else _resaid(sentence, language, _DEPTH)


@lru_cache(maxsize=4096)
def _resaid(sentence: str, language: Language, depth: int) -> str:
    exact = _exact(language).get(sentence)
    if exact is not None:
        return exact
    for text in (sentence, *_in_plural(sentence)):
        found = _matched(text, _terminal_patterns(language), language, depth, _resaid)
        if found is not None:
            return found
    found = _matched(sentence, _patterns(language), language, depth, _resaid)
    return _in_parts(sentence, language, depth, _resaid) if found is None else found


def _in_plural(sentence: str) -> tuple[str, ...]:
    """Return what may be one thing as several: the catalogue counts in the plural alone."""
    return (re.sub(r"^1 (\w+)", r"1 \1s", sentence), f"{sentence}s") if sentence.startswith("1 ") else ()


@lru_cache
def _exact(language: Language) -> Mapping[str, str]:
    other = terminal(language)
    return {text: other[key] for key, text in terminal("en").items() if not _SLOT.search(text)}


@lru_cache
def _terminal_patterns(language: Language) -> Patterns:
    return _compiled({key: text for key, text in terminal("en").items() if _SLOT.search(text)}, terminal(language))


def text(section: Section, key: str, language: Language = "en", *values: object) -> str:
    """Return a word or sentence with its slots filled. Raises KeyError: the catalogue has none of that key."""
    sentence = catalogue(language)[section][key]
    for number, value in enumerate(values):
        sentence = sentence.replace(f"{{{number}}}", str(value))
    return settled(sentence) if language == "ko" else sentence


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
    found = _matched(sentence, _patterns(language), language, depth, _retold)
    return _in_parts(sentence, language, depth, _retold) if found is None else found


def _in_parts(sentence: str, language: Language, depth: int, tell: Tell) -> str:
    """Tell a reason, and what would help, each by itself."""
    reason, found_one, remedy = sentence.partition("; ")
    if not found_one or not depth:
        return sentence
    return f"{tell(reason, language, depth - 1)}; {tell(remedy, language, depth - 1)}"


def _matched(sentence: str, patterns: Patterns, language: Language, depth: int, within: Tell) -> str | None:
    for fixed, pattern, other in patterns:
        if fixed in sentence and (match := pattern.fullmatch(sentence)):
            return _filled(other, match.groupdict(), language, depth, within)
    return None


def _filled(other: str, parts: Mapping[str, str], language: Language, depth: int, within: Tell) -> str:
    def part(slot: re.Match[str]) -> str:
        found = parts.get(f"s{slot[0][1]}", slot[0])
        return within(found, language, depth - 1) if depth and " " in found else found

    whole = _SLOT.sub(part, other)
    return settled(whole) if language == "ko" else whole


@lru_cache
def _patterns(language: Language) -> Patterns:
    english, other = catalogue("en"), catalogue(language)
    return _compiled({**english["sayings"], **_keyed(english)}, {**other["sayings"], **_keyed(other)})


def _keyed(words: Mapping[Section, Mapping[str, str]]) -> dict[str, str]:
    """Return the names that come with the product beside the sayings: keys of both may be the same word."""
    return {f"name {key}": name for key, name in words["names"].items()}


def _compiled(english: Mapping[str, str], other: Mapping[str, str]) -> Patterns:
    """Return patterns with what they mean, those with most letters of their own first."""
    rows = sorted(english.items(), key=lambda row: -len(_SLOT.sub("", row[1])))
    return [
        (max(_FIXED.split(sentence), key=len), re.compile(_pattern(sentence), re.DOTALL), other[key])
        for key, sentence in rows
    ]


def _pattern(sentence: str) -> str:
    """Return it as an expression. What stands first is a name, or several: a clause within a sentence is none by itself."""
    first, *rest = (part for part in _SLOT.split(sentence) if part)
    head = _slot(first, r"\S+?(?: \(for \S+?\))?(?:, \S+?)*?") if _SLOT.fullmatch(first) else re.escape(first)
    return head + "".join(_slot(part, ".+?") if _SLOT.fullmatch(part) else re.escape(part) for part in rest)


def _slot(part: str, filled: str) -> str:
    return rf"(?P<s{part[1]}>{_NUMBER if part == COUNT else filled})"
