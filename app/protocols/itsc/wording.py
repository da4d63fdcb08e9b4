"""What the numbers in iTSC's packets mean, for people: each meaning in English and in Korean (PROTOCOLS 1.6 to 1.9)."""

from collections.abc import Mapping
from typing import Literal

from app.protocols.itsc.messages import Code

Language = Literal["en", "ko"]
Text = tuple[str, str]
"""The same in English and in Korean."""

UNDEFINED: Text = ("undefined", "정의되지 않음")
RESERVED: Text = ("reserved", "예약")

_STOP: Text = ("stopped", "정지")
_DRIVING: Text = ("driving", "구동 중")
_HOME: Text = ("home", "홈 위치")
_NOT_READY: Text = ("servo not ready", "서보 준비 안 됨")
_ERROR: Text = ("servo error", "서보 에러")

NIBBLES: Mapping[str, Mapping[int, Text]] = {
    "trav": {
        0: _STOP,
        1: ("stopped on a tag: port position DSTP", "태그 위치 정지: 포트 DSTP"),
        2: ("stopped at DSTL", "DSTL 위치 정지"),
        3: ("stopped at DSTP and DSTL", "DSTP·DSTL 위치 정지"),
        4: ("stopped at DSTR", "DSTR 위치 정지"),
        5: ("stopped at DSTP and DSTR", "DSTP·DSTR 위치 정지"),
        6: ("stopped at DSTL and DSTR", "DSTL·DSTR 위치 정지"),
        7: ("stopped at DSTP, DSTL and DSTR", "DSTP·DSTL·DSTR 위치 정지"),
        8: _DRIVING,
        10: _ERROR,
        11: _NOT_READY,
        12: ("rear bumper detected", "후방 범퍼 감지"),
        13: ("front bumper detected", "전방 범퍼 감지"),
    },
    "shft": {0: _STOP, 1: _HOME, 3: ("left limit", "좌측 리미트"), 4: ("right limit", "우측 리미트"), 8: _DRIVING},
    "rota": {
        0: _STOP,
        1: _HOME,
        3: ("CCW (left) limit", "CCW(좌측) 리미트"),
        4: ("CW (right) limit", "CW(우측) 리미트"),
        8: _DRIVING,
        10: _ERROR,
        11: _NOT_READY,
    },
    "lift": {0: _STOP, 1: _HOME, 8: _DRIVING, 10: _ERROR, 11: _NOT_READY},
    "slid": {
        0: ("left side", "좌측"),
        1: _HOME,
        2: ("right side", "우측"),
        3: ("left limit", "좌측 리미트"),
        4: ("right limit", "우측 리미트"),
        5: ("left destination", "좌측 목적 위치"),
        6: ("right destination", "우측 목적 위치"),
        8: _DRIVING,
        10: _ERROR,
        11: _NOT_READY,
    },
    "grip": {
        0: _STOP,
        1: ("open", "열림"),
        3: ("closed", "닫힘"),
        4: ("wide", "넓게 열림"),
        8: _DRIVING,
        10: ("driver error", "드라이버 에러"),
    },
    "sftb": {0: _STOP, 3: ("open", "열림"), 4: ("raised", "올림"), 8: _DRIVING},
}
"""STATUS1's axes (1.8); the union of both documents, B's words first (I27)."""

FOUP: Mapping[int, Text] = {0: ("no FOUP", "FOUP 없음"), 1: ("carries a FOUP", "FOUP 적재")}
MODES: Mapping[int, Text] = {
    0: ("MANT, maintenance", "MANT, 정비"),
    1: ("SEMI", "SEMI, 반자동"),
    3: ("AUTO", "AUTO, 자동"),
}
OPERS: Mapping[int, Text] = {
    0: ("IDLE", "IDLE, 대기"),
    1: ("ALARM", "ALARM, 알람"),
    2: ("RUN", "RUN, 동작 중"),
    3: ("PAUSE", "PAUSE, 일시 정지"),
}
FLAGS: Mapping[str, tuple[str, Text, Text]] = {
    "at_barcode": ("R", ("no barcode recognised", "바코드 인식 안 됨"), ("barcode recognised", "바코드 인식")),
    "all_home": ("H", ("not all devices at home", "전체 홈 위치 아님"), ("all devices at home", "전체 홈 위치")),
    "home_known": (
        "F",
        ("home position not recognised", "홈 위치 미인식"),
        ("home position recognised", "홈 위치 인식"),
    ),
    "servos_on": ("S", ("not all servos on", "전체 서보 온 아님"), ("all servos on", "전체 서보 온")),
}
ALARM_CODE: Text = ("alarm code", "알람 코드")
PROCESS_CODE: Text = ("process code", "공정 코드")

ACTIONS: Mapping[int, Text] = {
    0: ("run", "주행"),
    1: ("stop", "정지"),
    2: ("stop to the PORT position", "PORT 위치로 정지"),
    3: ("stop to the SBFL position", "SBFL 위치로 정지"),
    4: ("stop to the SBFR position", "SBFR 위치로 정지"),
    5: ("stop to the PORT position without preparative action", "사전 동작 없이 PORT 위치로 정지"),
}

FIELDS: Mapping[tuple[str, str], Mapping[int, Text]] = {
    ("RESP1", "result"): {0: ("completed normally", "정상 완료"), 1: ("completed abnormally", "비정상 완료")},
    ("DISP", "opt"): {0: ("notice without alarm", "알람 없는 안내"), 1: ("notice with alarm", "알람 있는 안내")},
    ("REQ", "opt1"): {0: ("without PIO handshake", "PIO 핸드셰이크 없음"), 1: ("with PIO handshake", "PIO 핸드셰이크")},
    ("REQ", "opt2"): {0: ("no repeat", "반복 없음"), 1: ("repeat", "반복")},
    ("JOG", "opt"): {
        1: ("absolute", "절대 위치 이동"),
        2: ("relative", "상대 위치 이동"),
        3: ("speed move forward, down or right", "전진·하강·우측 속도 이동"),
        4: ("speed move backward, up or left", "후진·상승·좌측 속도 이동"),
    },
    ("INFR", "opt"): {
        0: ("firmware version", "펌웨어 버전"),
        1: ("TRAV position", "TRAV 위치"),
        2: ("SHFT position", "SHFT 위치"),
        3: ("ROTA position", "ROTA 위치"),
        4: ("LIFT position", "LIFT 위치"),
        5: ("SLID position", "SLID 위치"),
    },
}
"""What the values of an option mean."""

UNITS: Mapping[str, Text] = {
    "shft": ("pulses, target of the shifter", "펄스, 시프터 목표 위치"),
    "rota": ("pulses, target of the rotator", "펄스, 로테이터 목표 위치"),
    "lift": ("pulses, target of the lifter", "펄스, 리프터 목표 위치"),
    "lkdn": ("look-down sensor area", "하방 감시 영역"),
    "spd": ("% of full speed", "% 속도"),
    "speed": ("% of full speed", "% 속도"),
    "sensor": ("obstacle sensor area", "장애물 센서 영역"),
    "dist": ("mm from the barcode", "mm, 현재 바코드부터의 거리"),
    "dist_act": ("mm after the barcode", "mm, 바코드 이후 적용 거리"),
    "dist_next": ("mm to the next barcode", "mm, 다음 바코드까지"),
    "pos": ("pulses, axis position", "펄스, 축 위치"),
    "value": ("pulses", "펄스"),
    "seq": ("number in the path", "경로 순번"),
    "barcode": ("barcode", "바코드"),
    "alarm": ("alarm number", "알람 번호"),
    "zone": ("zone", "구역"),
    "length": ("bytes of sub data", "서브 데이터 바이트 수"),
    "count": ("path elements", "경로 요소 수"),
    "text": ("text shown on the vehicle", "차량 표시 문구"),
    "foup_id": ("FOUP ID, for display", "FOUP ID, 표시용"),
    "source": ("source, for display", "출발지, 표시용"),
    "destination": ("destination, for display", "목적지, 표시용"),
    "stid": ("storage or port id", "스토리지 또는 포트 ID"),
    "data": ("data without a known format", "형식을 알 수 없는 데이터"),
}

PACKETS: Mapping[str, Text] = {
    "ENQ": ("command, answer or event", "명령·응답·이벤트"),
    "ETB": ("command with a sub packet", "서브 패킷이 있는 명령"),
    "ACK": ("received without error", "정상 수신"),
    "NAK": ("send again", "재전송 요청"),
}
BY_VEHICLE: Text = ("given by the vehicle", "차량이 부여")
BY_CONTROLLER: Text = ("given by the controller", "제어기가 부여")
UNKNOWN_CODE: Text = ("unknown code", "알 수 없는 코드")

DIRECTIONS: Mapping[str, Text] = {
    "TC>VEH": ("controller to vehicle", "제어기 → 차량"),
    "VEH>TC": ("vehicle to controller", "차량 → 제어기"),
    "both": ("either way", "양방향"),
}
PROBLEM: Text = ("problem", "문제")
GARBLED: Mapping[str, Text] = {
    "noise": ("no packet starts here", "패킷 시작 아님"),
    "crc": ("the CRC does not fit", "CRC 불일치"),
    "length": ("LENGTH is too large", "LENGTH 초과"),
    "truncated": ("the packet is not complete", "패킷이 완전하지 않음"),
}
ZERO_ANSWER: Text = (
    "from the vehicle the same bytes would be {form} with every field 0",
    "차량이 보낸 것이라면 모든 필드가 0인 {form}",
)
OTHER_DIALECT: Text = (
    "dialect {name} makes more sense of it{extra}: try --dialect {name}",
    "방언 {name}이 더 잘 맞음{extra}: --dialect {name} 사용",
)
OTHER_CRC: Text = (
    "the CRC fits with crc {crc}, crc_covers_type {crc_covers_type}, crc_order {crc_order}",
    "crc {crc}, crc_covers_type {crc_covers_type}, crc_order {crc_order}이면 CRC가 맞음",
)

NAMES: Mapping[Code, Text] = {
    Code.SERVO_ON: ("SERVO ON", "서보 온"),
    Code.SERVO_OFF: ("SERVO OFF", "서보 오프"),
    Code.SEARCH_HOME: ("SEARCH HOME", "홈 탐색"),
    Code.GO_HOME: ("GO HOME", "홈 이동"),
    Code.SYSTEM_RESET: ("SYSTEM RESET", "시스템 리셋"),
    Code.ALARM_CLEAR: ("ALARM CLEAR", "알람 해제"),
    Code.AUTO: ("AUTO", "자동 전환"),
    Code.STATUS: ("STATUS", "상태"),
    Code.DISTANCE: ("DISTANCE", "거리"),
    Code.STOP: ("STOP", "정지"),
    Code.STOP_BY_HOST: ("STOP BY HOST", "호스트 정지"),
    Code.MOVE: ("MOVE", "이동"),
    Code.XMOVE: ("XMOVE", "이동 변경"),
    Code.PICKUP_FROM_PORT: ("PICKUP FROM PORT", "포트에서 픽업"),
    Code.PLACE_TO_PORT: ("PLACE TO PORT", "포트에 내려놓기"),
    Code.PICKUP_FROM_SBFL: ("PICKUP FROM SBFL", "좌측 버퍼에서 픽업"),
    Code.PLACE_TO_SBFL: ("PLACE TO SBFL", "좌측 버퍼에 내려놓기"),
    Code.PICKUP_FROM_SBFR: ("PICKUP FROM SBFR", "우측 버퍼에서 픽업"),
    Code.PLACE_TO_SBFR: ("PLACE TO SBFR", "우측 버퍼에 내려놓기"),
    Code.SHFT_DEST_TEACHING: ("SHFT DEST TEACHING", "시프터 목적 위치 티칭"),
    Code.SHFT_OFFSET_TEACHING: ("SHFT OFFSET TEACHING", "시프터 오프셋 티칭"),
    Code.ROTA_DEST_TEACHING: ("ROTA DEST TEACHING", "로테이터 목적 위치 티칭"),
    Code.ROTA_OFFSET_TEACHING: ("ROTA OFFSET TEACHING", "로테이터 오프셋 티칭"),
    Code.LIFT_DEST_TEACHING: ("LIFT DEST TEACHING", "리프터 목적 위치 티칭"),
    Code.LIFT_OFFSET_TEACHING: ("LIFT OFFSET TEACHING", "리프터 오프셋 티칭"),
    Code.PORT_DEST_TEACHING: ("PORT DEST TEACHING", "포트 목적 위치 티칭"),
    Code.PORT_OFFSET_TEACHING: ("PORT OFFSET TEACHING", "포트 오프셋 티칭"),
    Code.DISPLAY_BY_HOST: ("DISPLAY BY HOST", "호스트 표시"),
}


def said(text: Text, language: Language) -> str:
    """Return a text in a language."""
    return text[language == "ko"]
