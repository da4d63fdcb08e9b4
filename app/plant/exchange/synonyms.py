"""The words by which columns, kinds of station and answers are called, in English and Korean."""

from app.domain.layout import StationKind

COLUMNS = {
    "barcode": """
        barcode barcodeid barcodeno barcodenumber barcodename bcr bcrid bcrno bc node nodeid nodeno nodename
        point pointid pointname tag tagid tagno mark markid rfid 바코드 바코드번호 바코드id 바코드명 노드
        노드번호 노드id 노드명 포인트 포인트id 태그 태그번호
    """,
    "x": """
        x xpos posx positionx xposition xcoord xcoordinate coordx locx xmm x좌표 좌표x x위치 위치x 가로
        가로좌표 엑스
    """,
    "y": """
        y ypos posy positiony yposition ycoord ycoordinate coordy locy ymm y좌표 좌표y y위치 위치y 세로
        세로좌표 와이
    """,
    "next": """
        next nextbarcode nextbarcodes nextbarcodeid nextnode nextnodes nextnodeid nextid nextpoint nexttag
        successor successors following branch branchbarcode 다음 다음바코드 다음노드 다음번호 다음id
        다음포인트 후속 후속바코드 후행 후행바코드 분기 분기바코드 연결 연결바코드 연결노드
    """,
    "from": """
        from frombarcode fromnode fromid frompoint source sourcebarcode sourcenode startbarcode startnode
        startnodeid start 시작 시작바코드 시작노드 시작점 출발 출발바코드 출발노드 출발지
    """,
    "to": """
        to tobarcode tonode toid topoint target targetbarcode targetnode endbarcode endnode endnodeid end
        destination 끝 끝바코드 끝노드 끝점 종료 종료바코드 종료노드 도착 도착바코드 도착노드 도착지
    """,
    "length": """
        length len distance dist distancetonext disttonext nextdistance lengthtonext nextlength edgelength
        weight 거리 길이 구간거리 구간길이 다음거리 다음까지거리 이격거리
    """,
    "speed": """
        speed spd velocity maxspeed maxvelocity speedlimit vmax limitspeed 속도 최고속도 최대속도 제한속도
        속도제한 주행속도
    """,
    "sensor": """
        sensor sensorarea area obstacle obstaclesensor obstaclearea obstaclesensorarea pbs 센서 센서영역
        감지영역 장애물센서 장애물감지
    """,
    "curve": "curve curved iscurve shape bend 곡선 곡선여부 커브 형상 직선곡선",
    "station": """
        station stationid stationname stationno port portid portname eqport loadport stk 스테이션 스테이션명
        스테이션id 포트 포트명 포트id 설비 설비명 설비포트
    """,
    "kind": """
        kind type stationtype stationkind porttype portkind 종류 유형 타입 구분 포트종류 포트유형
        스테이션종류 스테이션유형
    """,
    "display": "display displayname shownas 표시 표시명 표시이름",
    "look_down": "lookdown lkdn lookdownarea 룩다운 하방감지",
    "shft": "shft shift shftdest 시프트",
    "rota": "rota rotation rotate rotadest 회전",
    "lift": "lift hoistheight liftdest 승강 리프트",
    "carrier": "carrier carrierid foup foupid cart cartid 캐리어 캐리어id 풉 포웁",
    "fallbacks": "fallback fallbacks alternative alternatives 대체 대체포트 대체스테이션",
    "park": "park parking parkingplace parkingplaces waiting waitingplace 주차 주차위치 대기 대기위치 대기장소",
    "zone": "zone zoneid zonename 구역 구역명 존 영역",
    "capacity": "capacity zonecapacity 용량 최대대수 수용대수",
    "direction": "direction dir bidirectional twoway 방향 통행방향 양방향 통행",
    "vehicle": """
        vehicle vehicleid vehiclename oht ohtid ohtno ohv hoist hoistid agv agvid agvno 차량 차량명 차량번호
        차량id 호기 대차
    """,
    "dev_id": "devid deviceid dev devno deviceno 장치번호 기기번호 디바이스번호 장치id",
    "address": "address addr ip ipaddress ipaddr host hostport 주소 ip주소 아이피",
    "port_number": "tcpport ipport portnumber portno 포트번호",
}
"""Names of columns by role; case, spaces and marks do not count."""

KINDS = {
    StationKind.PORT: "port loadport lp eqport eq equipment stocker stk 포트 설비 로드포트",
    StationKind.SBFL: "sbfl left leftbuffer sidebufferleft bufferleft lsb utbl stbl 좌 좌측 좌버퍼 좌측버퍼 왼쪽버퍼",
    StationKind.SBFR: "sbfr right rightbuffer sidebufferright bufferright rsb utbr stbr 우 우측 우버퍼 우측버퍼 오른쪽버퍼",
    StationKind.AGV_BUFFER: "agvbuffer agv buffer cart cartbuffer 버퍼 대차버퍼 agv버퍼",
}

CHARGER = "charger charge charging 충전 충전기 충전소"
PARK = "park parking waiting wait 주차 대기 대기장소"
TRUE = "1 y yes true t o x on v ✓ ○ 예 유 참 있음 곡선 curve curved c 커브"
FALSE = "0 n no false f - off 아니오 무 거짓 없음 직선 straight s line"
BOTH = "2 both two-way twoway bidirectional bi <-> ↔ 양방향 양방 y yes true"
ONE_WAY = "1 one-way oneway forward unidirectional uni -> → 단방향 일방향 일방 n no false 0"
BACKWARD = "backward reverse <- ← 역방향"
