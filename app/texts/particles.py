"""Korean particles go by the sound before them: which of 이(가), 을(를) … it is, where the end of a name tells."""

import re
from typing import Literal

Sound = Literal["vowel", "consonant", "l"]
"""How what stands before a particle ends. After ㄹ (l) it is 로, not 으로; else ㄹ is a consonant like the others."""
FORMS = {
    "이(가)": ("가", "이"),
    "은(는)": ("는", "은"),
    "을(를)": ("를", "을"),
    "과(와)": ("와", "과"),
    "와(과)": ("와", "과"),
    "(으)로": ("로", "으로"),
    "(이)라": ("라", "이라"),
    "(이)나": ("나", "이나"),
    "(이)고": ("고", "이고"),
    "(이)며": ("며", "이며"),
}
"""As the texts write them: after a vowel, after a consonant."""
_FORM = re.compile(rf"(?<=\S) ?({'|'.join(map(re.escape, FORMS))})")
_REMARK = re.compile(r"\([^()]*\)$")
"""What stands in brackets is not read: the particle goes by the word before them."""
_UNIT = re.compile(r"[0-9] ?(?:mm|cm|m|km|s|ms|h|mm/s|m/s|MB|GB|%)$")
_DIGITS: dict[str, Sound] = {"0": "consonant", "1": "l", "3": "consonant", "6": "consonant", "7": "l", "8": "l"}
_LETTERS: dict[str, Sound] = {"L": "l", "M": "consonant", "N": "consonant", "R": "l"}
"""Letters whose Korean names end in a consonant: 엘, 엠, 엔, 알."""
_OPEN = frozenset("aiouywrdgfvszxh")
_SPOKEN: dict[str, Sound] = {"l": "l", "m": "consonant", "n": "consonant"}
"""Ends of words that are read as words; of others (port, map, node, job) letters alone do not tell."""
_ABBREVIATION = 3
"""Capitals of so many letters, or without a vowel among them, are read letter by letter; DOOR may be read as a word."""


def settled(text: str) -> str:
    """Return a text with the particle that fits in each place where it can be told; elsewhere 이(가) stays as it is."""
    parts: list[str] = []
    at = 0
    for form in _FORM.finditer(text):
        before = "".join((*parts, text[at : form.start()]))
        if (sound := sound_of(before)) is not None:
            parts = [before, _chosen(form[1], sound)]
            at = form.end()
    return "".join((*parts, text[at:]))


def _chosen(form: str, sound: Sound) -> str:
    open_, closed = FORMS[form]
    return open_ if sound == "vowel" or (sound == "l" and form == "(으)로") else closed


def sound_of(text: str) -> Sound | None:
    """Return how a text ends, read aloud in Korean: 가 a vowel, V1 (일) an l, None: its letters do not tell."""
    text = text.rstrip("'\"’”」`")
    while (shorter := _REMARK.sub("", text).rstrip("'\"’”」` ")) != text and shorter:
        text = shorter
    if _UNIT.search(text):
        return "vowel"
    last = text[-1:]
    if "가" <= last <= "힣":
        return _of_syllable(last)
    if last.isascii() and last.isdigit():
        return _DIGITS.get(last, "vowel")
    word = re.search(r"[A-Za-z]*$", text)
    assert word is not None
    return _of_letters(word[0]) if word[0] else None


def _of_syllable(letter: str) -> Sound:
    final = (ord(letter) - ord("가")) % 28
    return "vowel" if final == 0 else "l" if final == 8 else "consonant"


def _of_letters(word: str) -> Sound | None:
    capitals, by_name = word.isupper(), _LETTERS.get(word[-1].upper(), "vowel")
    if len(word) == 1 or (capitals and (len(word) <= _ABBREVIATION or not re.search("[AEIOUY]", word))):
        return by_name
    word = word.casefold()
    spoken = "consonant" if word.endswith("ng") else "vowel" if word[-1] in _OPEN else _SPOKEN.get(word[-1])
    return None if capitals and spoken != by_name else spoken
