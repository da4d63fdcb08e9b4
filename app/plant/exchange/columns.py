"""Which column of a table means what: names in English and Korean, units, directions."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from app.domain.layout import StationKind

_SYNONYMS = {
    "barcode": "barcode barcodeid barcodeno barcodenumber barcodename bcr bcrid bcrno bc node nodeid nodeno nodename point pointid"
    " pointname tag tagid tagno mark markid rfid 바코드 바코드번호 바코드id 바코드명 노드 노드번호 노드id 노드명 포인트 포인트id 태그 태그번호",
    "x": "x xpos posx positionx xposition xcoord xcoordinate coordx locx xmm x좌표 좌표x x위치 위치x 가로 가로좌표 엑스",
    "y": "y ypos posy positiony yposition ycoord ycoordinate coordy locy ymm y좌표 좌표y y위치 위치y 세로 세로좌표 와이",
    "next": "next nextbarcode nextbarcodes nextbarcodeid nextnode nextnodes nextnodeid nextid nextpoint nexttag successor successors"
    " following branch branchbarcode 다음 다음바코드 다음노드 다음번호 다음id 다음포인트 후속 후속바코드 후행 후행바코드 분기 분기바코드 연결"
    " 연결바코드 연결노드",
    "from": "from frombarcode fromnode fromid frompoint source sourcebarcode sourcenode startbarcode startnode startnodeid start"
    " 시작 시작바코드 시작노드 시작점 출발 출발바코드 출발노드 출발지",
    "to": "to tobarcode tonode toid topoint target targetbarcode targetnode endbarcode endnode endnodeid end destination"
    " 끝 끝바코드 끝노드 끝점 종료 종료바코드 종료노드 도착 도착바코드 도착노드 도착지",
    "length": "length len distance dist distancetonext disttonext nextdistance lengthtonext nextlength edgelength weight"
    " 거리 길이 구간거리 구간길이 다음거리 다음까지거리 이격거리",
    "speed": "speed spd velocity maxspeed maxvelocity speedlimit vmax limitspeed 속도 최고속도 최대속도 제한속도 속도제한 주행속도",
    "sensor": "sensor sensorarea area obstacle obstaclesensor obstaclearea obstaclesensorarea pbs 센서 센서영역 감지영역 장애물센서"
    " 장애물감지",
    "curve": "curve curved iscurve shape bend 곡선 곡선여부 커브 형상 직선곡선",
    "station": "station stationid stationname stationno port portid portname eqport loadport stk 스테이션 스테이션명 스테이션id 포트"
    " 포트명 포트id 설비 설비명 설비포트",
    "kind": "kind type stationtype stationkind porttype portkind 종류 유형 타입 구분 포트종류 포트유형 스테이션종류 스테이션유형",
    "display": "display displayname shownas 표시 표시명 표시이름",
    "look_down": "lookdown lkdn lookdownarea 룩다운 하방감지",
    "shft": "shft shift shftdest 시프트",
    "rota": "rota rotation rotate rotadest 회전",
    "lift": "lift hoistheight liftdest 승강 리프트",
    "fallbacks": "fallback fallbacks alternative alternatives 대체 대체포트 대체스테이션",
    "park": "park parking parkingplace parkingplaces waiting waitingplace 주차 주차위치 대기 대기위치 대기장소",
    "zone": "zone zoneid zonename 구역 구역명 존 영역",
    "capacity": "capacity zonecapacity 용량 최대대수 수용대수",
    "direction": "direction dir bidirectional twoway 방향 통행방향 양방향 통행",
    "vehicle": "vehicle vehicleid vehiclename oht ohtid ohtno ohv hoist hoistid agv agvid agvno 차량 차량명 차량번호 차량id 호기 대차",
    "dev_id": "devid deviceid dev devno deviceno 장치번호 기기번호 디바이스번호 장치id",
    "address": "address addr ip ipaddress ipaddr host hostport 주소 ip주소 아이피",
    "port_number": "tcpport ipport portnumber portno 포트번호",
}
ROLES = {synonym: role for role, names in _SYNONYMS.items() for synonym in names.split()}
WEAK = {"id": "barcode", "no": "barcode", "number": "barcode", "name": "barcode", "번호": "barcode", "이름": "barcode"}
"""Words that mean the barcode where no other column does."""

MM = {"mm": 1.0, "밀리": 1.0, "cm": 10.0, "m": 1000.0, "미터": 1000.0, "km": 1e6, "in": 25.4, "inch": 25.4, "ft": 304.8}
SPEEDS = {"%": 0.0, "percent": 0.0, "mm/s": 1.0, "mm/sec": 1.0, "m/s": 1000.0, "m/sec": 1000.0, "m/min": 1000 / 60, "mpm": 1000 / 60}
"""In mm/s; 0: percent of the vehicle's own."""
_UNIT = re.compile(r"[(\[{（]\s*([^)\]}）]{1,12}?)\s*[)\]}）]")
_TAIL = re.compile(r"(?:[_\s]+)(mm|cm|m|km|mm/s|m/s|m/min|%|percent)$")

KINDS = {
    StationKind.PORT: "port loadport lp eqport eq equipment stocker stk 포트 설비 로드포트",
    StationKind.SBFL: "sbfl left leftbuffer sidebufferleft bufferleft lsb utbl stbl 좌 좌측 좌버퍼 좌측버퍼 왼쪽버퍼",
    StationKind.SBFR: "sbfr right rightbuffer sidebufferright bufferright rsb utbr stbr 우 우측 우버퍼 우측버퍼 오른쪽버퍼",
    StationKind.AGV_BUFFER: "agvbuffer agv buffer cart cartbuffer 버퍼 대차버퍼 agv버퍼",
}
KIND_OF = {word: kind for kind, words in KINDS.items() for word in words.split()}
CHARGER_WORDS = frozenset("charger charge charging 충전 충전기 충전소".split())
PARK_WORDS = frozenset("park parking waiting wait 주차 대기 대기장소".split())
TRUE = frozenset("1 y yes true t o x on v ✓ ○ 예 유 참 있음 곡선 curve curved c 커브".split())
FALSE = frozenset("0 n no false f - off 아니오 무 거짓 없음 직선 straight s line".split()) | {""}
BOTH = frozenset("2 both two-way twoway bidirectional bi <-> ↔ 양방향 양방 y yes true".split())
ONE_WAY = frozenset("1 one-way oneway forward unidirectional uni -> → 단방향 일방향 일방 n no false 0".split()) | {""}
BACKWARD = frozenset("backward reverse <- ← 역방향".split())


@dataclass(frozen=True, slots=True)
class Column:
    """A column that is understood: its role, its place in a row (from 0), its own name, and its unit if one is named."""

    role: str
    index: int
    name: str
    unit: str = ""


def fold(text: str) -> str:
    """Return a column's name or a word as it is compared: case, spaces and marks do not count."""
    return re.sub(r"[\s_\-./#:·]+", "", text.casefold())


def unit_in(name: str) -> tuple[str, str]:
    """Return a column's name without its unit, and the unit as it is written, in lower case."""
    match = _UNIT.search(name)
    if match is not None:
        unit = match[1].casefold().replace(" ", "")
        return (name[: match.start()] + name[match.end() :]).strip(), unit if unit in MM or unit in SPEEDS else ""
    match = _TAIL.search(name.casefold())
    return (name[: match.start()], match[1]) if match else (name, "")


def columns_of(header: Sequence[object]) -> list[Column]:
    """Return the columns that are understood, in their order; several may mean the next barcode, else the first counts."""
    found: list[Column] = []
    for index, cell in enumerate(header):
        bare, unit = unit_in(str(cell))
        folded = fold(bare)
        role = ROLES.get(folded) or ROLES.get(folded.rstrip("0123456789"))
        if role is not None and (role == "next" or all(column.role != role for column in found)):
            found.append(Column(role, index, str(cell).strip(), unit))
    return _with_contexts(found, header)


def _with_contexts(found: list[Column], header: Sequence[object]) -> list[Column]:
    """Settle what only the other columns tell: a vehicle's start, a lone ``to``, a bare ``id``."""
    roles = {column.role for column in found}
    if "barcode" not in roles and "from" not in roles:
        weak = [
            Column("barcode", index, str(cell).strip())
            for index, cell in enumerate(header)
            if fold(str(cell)) in WEAK and all(column.index != index for column in found)
        ]
        found = [*weak[:1], *found]
    if "vehicle" in roles and "from" in roles and "to" not in roles:
        return [Column("start", c.index, c.name) if c.role == "from" else c for c in found]
    if "to" in roles and "from" not in roles:
        return [Column("next", c.index, c.name, c.unit) if c.role == "to" else c for c in found]
    if "from" in roles and "to" not in roles and "next" in roles and "barcode" not in roles:
        return [Column("barcode", c.index, c.name) if c.role == "from" else c for c in found]
    return found
