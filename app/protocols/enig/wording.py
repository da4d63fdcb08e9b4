"""What ENIG's commands and numbers mean, for people: each meaning in English and in Korean (PROTOCOLS 3.2, 3.3)."""

from collections.abc import Mapping
from typing import Literal

Language = Literal["en", "ko"]
Text = tuple[str, str]
"""The same in English and in Korean."""


def said(text: Text, language: Language) -> str:
    """Return a text in a language."""
    return text[1] if language == "ko" else text[0]


UNDEFINED: Text = ("undefined", "정의되지 않음")
UNKNOWN_COMMAND: Text = ("unknown command", "알 수 없는 명령")
PROBLEM: Text = ("problem", "문제")
OTHER_CRC: Text = (
    "dialect {name} makes sense of {frames} packets in it",
    "방언 {name}(으)로 패킷 {frames}개를 해석할 수 있음",
)
HOST: Text = ("host (ACS)", "호스트(ACS)")
NOBODY: Text = ("no device of this dialect", "이 방언에 없는 장비")

DIRECTIONS: Mapping[str, Text] = {
    "H>E": ("host to device", "호스트에서 장비로"),
    "E>H": ("device to host", "장비에서 호스트로"),
}
CLASSES: Mapping[str, Text] = {
    "agv": ("AGV", "AGV"),
    "buffer": ("buffer", "버퍼"),
    "door": ("door", "출입문"),
}
NAMES: Mapping[str, Text] = {
    "Move": ("drive to a tag", "대상 태그까지 이동"),
    "Stop": ("stop", "멈춤"),
    "Reset": ("clear the error", "오류 소거"),
    "SetCurrent": ("set the present position", "현재 위치 설정"),
    "MoveManual": ("drive in manual mode", "매뉴얼 이동"),
    "MarkStop": ("stop at the next mark", "마크 센서 스톱"),
    "Lift": ("lift", "리프트 제어"),
    "MoveAlias": ("drive to a destination", "대상 별칭까지 이동"),
    "MoveAuto": ("follow the tape", "자동 이동"),
    "Charge": ("charge", "충전 실행"),
    "MoveComplete": ("arrived", "목적지 이동 완료"),
    "TagReceived": ("tag read", "태그 인식"),
    "Status": ("state", "상태"),
    "Lock": ("lock", "잠금"),
    "UnLock": ("unlock", "잠금 해제"),
    "Open": ("open the door", "출입문 열기"),
    "Close": ("close the door", "출입문 닫기"),
}

_OFF_ON: Mapping[int, Text] = {0: ("off", "꺼짐"), 1: ("on", "켜짐")}
_UNKNOWN: Text = ("unknown", "알 수 없음")
_SPEED: Mapping[int, Text] = {0: ("slow", "저속"), 1: ("normal", "보통"), 2: ("fast", "고속")}
_STEERING: Mapping[int, Text] = {0: ("straight", "직진"), 1: ("left", "좌측"), 2: ("right", "우측")}
_BUSY: Text = ("busy", "바쁨")
_ERROR: Text = ("error", "오류")

VALUES: Mapping[tuple[str, str], Mapping[int, Text]] = {
    ("AgvReport", "mode"): {0: ("manual", "수동"), 1: ("auto", "자동")},
    ("AgvReport", "run"): {0: ("stopped", "정지"), 1: ("running", "주행"), 2: _ERROR},
    ("AgvReport", "direction"): {**_STEERING, 3: ("mark stop", "마크 스톱")},
    ("AgvReport", "inposition"): {
        0: ("not at the destination", "목적 위치 아님"),
        1: ("at the destination", "목적 위치 도달"),
    },
    ("AgvReport", "charge"): _OFF_ON,
    ("AgvReport", "cart"): {0: ("no cart", "카트 없음"), 1: ("cart", "카트 있음"), 2: _UNKNOWN},
    ("AgvReport", "lift"): {0: ("down", "하강"), 1: ("up", "상승"), 2: _UNKNOWN},
    ("MoveManual", "direction"): {
        0: ("backward", "후진"),
        1: ("forward", "전진"),
        2: ("turn left", "좌회전"),
        3: ("turn right", "우회전"),
    },
    ("MoveManual", "speed"): _SPEED,
    ("Lift", "action"): {0: ("stop", "정지"), 1: ("up", "상승"), 2: ("down", "하강")},
    ("MoveAuto", "motor"): {0: ("backward", "후진"), 1: ("forward", "전진")},
    ("MoveAuto", "magnet"): _STEERING,
    ("MoveAuto", "speed"): _SPEED,
    ("Charge", "action"): {0: ("charge off", "충전 끔"), 1: ("charge on", "충전 켬")},
    ("BufferReport", "state"): {
        0: ("no cart", "카트 없음"),
        1: ("cart", "카트 있음"),
        2: _BUSY,
        3: _UNKNOWN,
        255: _ERROR,
    },
    ("DoorReport", "state"): {0: ("closed", "닫힘"), 1: ("open", "열림"), 2: _BUSY, 3: _UNKNOWN, 255: _ERROR},
}
"""What the numbers in a record's field mean."""

GARBLED: Mapping[str, Text] = {
    "noise": ("no packet starts here", "여기서 시작하는 패킷 없음"),
    "crc": ("the CRC does not fit", "CRC 불일치"),
    "length": ("LEN cannot be", "LEN 값 오류"),
    "etx": ("no ETX at the end", "끝에 ETX 없음"),
    "truncated": ("a packet that does not end", "끝나지 않은 패킷"),
}
