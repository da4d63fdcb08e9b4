"""What the letters and numbers in HI packets mean, for people: each in English and in Korean (PROTOCOLS 2.4)."""

from collections.abc import Mapping
from typing import Literal

from app.protocols.hi.framing import Reason
from app.protocols.hi.messages import Cmd

Language = Literal["en", "ko"]
Text = tuple[str, str]
"""The same in English and in Korean."""

COMMANDS: Mapping[str, Text] = {
    Cmd.RUN: ("Run key", "운전 키"),
    Cmd.SRK: ("Stop/Reset key", "정지/리셋 키"),
    Cmd.UPP: ("Up key", "업 키"),
    Cmd.DWN: ("Down key", "다운 키"),
    Cmd.DSK: ("Data/Set key", "데이터/셋 키"),
    Cmd.SET: ("read a parameter", "파라미터 읽기"),
    Cmd.SED: ("write a parameter", "파라미터 쓰기"),
    Cmd.INP: ("set the inputs", "입력 설정"),
    Cmd.SSQ: ("ask for the status", "상태 요청"),
    Cmd.PDT: ("known from the worked example alone", "예제에만 나오는 명령"),
    Cmd.ACK: ("taken", "수신 확인"),
    Cmd.NAK: ("not taken: the checksum was wrong", "체크섬 오류로 거부"),
    Cmd.BSY: ("not taken: moving, or storing data", "동작 중 또는 저장 중이라 거부"),
    Cmd.SSA: ("status", "상태"),
}
PARAMETER: Text = ("a parameter's value", "파라미터 값")
UNKNOWN_COMMAND: Text = ("not in the command table", "명령표에 없음")
MASTER: Text = ("from the master", "상위 제어기 송신")
SLAVE: Text = ("from the drive", "드라이브 송신")
ALL: Text = ("all drives, none answers", "모든 드라이브, 응답 없음")
DRIVE: Text = ("drive", "드라이브")
UNFIT: Text = ("does not fit the command", "명령에 맞지 않음")
LAST: Text = ("end of the packet", "패킷 끝")
CONTINUED: Text = ("continued in the next packet", "다음 패킷으로 이어짐")
SUM: Text = ("fits", "일치")
OTHER_DIALECT: Text = ("dialect {name} makes more sense of it", "{name} 방언이 더 잘 맞음")

FIELDS: Mapping[str, tuple[str, Text]] = {
    "number": ("YY", ("parameter number, hexadecimal", "파라미터 번호(16진)")),
    "value": ("VVV", ("value", "값")),
    "mode": ("X", ("mode", "모드")),
    "output": ("O", ("output", "출력")),
    "status": ("FF", ("", "")),
    "direction": ("K", ("direction", "방향")),
    "distance_centi": ("GGGGgg", ("distance moved, mm", "이동 거리, mm")),
    "run": ("a", ("RUN input", "RUN 입력")),
    "home": ("b", ("HOME input", "HOME 입력")),
    "r_limit": ("c", ("right limit input", "우측 리미트 입력")),
    "l_limit": ("d", ("left limit input", "좌측 리미트 입력")),
    "steps": ("e", ("step select, IN3 to IN0", "스텝 선택 IN3~IN0")),
}
"""Each field's letter in the specification, and what it is."""

MODES: tuple[Text, ...] = (
    ("parameter select", "파라미터 선택"),
    ("parameter value", "파라미터 값"),
    ("monitoring", "모니터링"),
    ("jog", "조그"),
    ("error", "에러"),
)
DIRECTIONS: tuple[Text, ...] = (("CW", "CW(시계 방향)"), ("CCW", "CCW(반시계 방향)"))

REASONS: Mapping[Reason, Text] = {
    Reason.NOISE: ("no packet starts here", "패킷 시작이 아님"),
    Reason.FORMAT: ("not of the packet's form", "패킷 형식이 아님"),
    Reason.BCC: ("wrong BCC", "BCC 오류"),
    Reason.TRUNCATED: ("an incomplete packet", "불완전한 패킷"),
}


def said(text: Text, language: Language) -> str:
    """Return a text in a language."""
    return text[language == "ko"]
