"""Layouts of other systems, small ones of our own, for the tests of import and export."""

import io
import json
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from app.plant.exchange.importing import Imported, Wishes, import_layout
from app.plant.exchange.report import Kind

RING = """barcode,x (mm),y (mm),next,station,type
1,0,0,2,,
2,1000,0,3,P1,port
3,2000,0,4,,
4,2000,1000,5,P2,port
5,1000,1000,6,B1,sbfl
6,0,1000,1,,
"""


def samples(kind: str) -> Path:
    """Return where files written by others lie, which are no part of this repository; it may not be there."""
    above = (parent / "shared" / "data" / kind for parent in Path(__file__).resolve().parents[3:])
    return next((folder for folder in above if folder.is_dir()), Path("shared") / "data" / kind)


def imported(text: str | bytes, name: str = "layout", wishes: Wishes | None = None) -> Imported:
    """Return what one file makes."""
    data = text.encode() if isinstance(text, str) else text
    return import_layout([(name, data)], wishes or Wishes())


def said(made: Imported, kind: Kind) -> list[str]:
    """Return what the report says of one kind."""
    return [str(note) for note in made.report.notes if note.kind is kind]


def workbook(sheets: Mapping[str, Sequence[Sequence[object]]]) -> bytes:
    """Return an XLSX file with these rows: texts inline, numbers as numbers."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as book:
        kinds = "".join(
            f'<Override PartName="/xl/worksheets/sheet{i}.xml" ContentType='
            '"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/>'
            for i, _ in enumerate(sheets, 1)
        )
        main = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"
        book.writestr(
            "[Content_Types].xml",
            '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default '
            'Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
            f'<Override PartName="/xl/workbook.xml" ContentType="{main}"/>{kinds}</Types>',
        )
        relations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
        package = "http://schemas.openxmlformats.org/package/2006/relationships"
        book.writestr(
            "_rels/.rels",
            f'<?xml version="1.0"?><Relationships xmlns="{package}"><Relationship Id="r" '
            f'Type="{relations}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        )
        named = "".join(f'<sheet name="{name}" sheetId="{i}" r:id="r{i}"/>' for i, name in enumerate(sheets, 1))
        space = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
        book.writestr(
            "xl/workbook.xml",
            f'<?xml version="1.0"?><workbook xmlns="{space}" xmlns:r="{relations}"><sheets>{named}</sheets></workbook>',
        )
        links = "".join(
            f'<Relationship Id="r{i}" Type="{relations}/worksheet" Target="worksheets/sheet{i}.xml"/>'
            for i, _ in enumerate(sheets, 1)
        )
        book.writestr(
            "xl/_rels/workbook.xml.rels",
            f'<?xml version="1.0"?><Relationships xmlns="{package}">{links}</Relationships>',
        )
        for i, rows in enumerate(sheets.values(), 1):
            cells = "".join(f'<row r="{r}">{_row(row, r)}</row>' for r, row in enumerate(rows, 1))
            book.writestr(
                f"xl/worksheets/sheet{i}.xml",
                f'<?xml version="1.0"?><worksheet xmlns="{space}"><sheetData>{cells}</sheetData></worksheet>',
            )
    return made.getvalue()


def _row(row: Sequence[object], r: int) -> str:
    cells = []
    for i, value in enumerate(row):
        at = f"{chr(65 + i)}{r}"
        if isinstance(value, int | float):
            cells.append(f'<c r="{at}"><v>{value}</v></c>')
        else:
            cells.append(f'<c r="{at}" t="inlineStr"><is><t>{value}</t></is></c>')
    return "".join(cells)


def node(name: str, x: object, y: object, **more: Any) -> dict[str, Any]:
    """Return a node of LIF."""
    kind = {"vehicleTypeId": "tugger", **({"actions": more.pop("actions")} if "actions" in more else {})}
    return {"nodeId": name, "mapId": "m", "nodePosition": {"x": x, "y": y}, "vehicleTypeNodeProperties": [kind], **more}


def edge(start: str, end: str, **more: Any) -> dict[str, Any]:
    """Return an edge of LIF."""
    kind = {"vehicleTypeId": "tugger", "rotationAllowed": False, **more}
    return {
        "edgeId": f"{start}-{end}",
        "startNodeId": start,
        "endNodeId": end,
        "vehicleTypeEdgeProperties": [kind],
    }


def action(what: str) -> dict[str, Any]:
    """Return an action at a node."""
    return {"actionType": what, "blockingType": "HARD", "requirementType": "CONDITIONAL"}


def lif(nodes: Sequence[Any], edges: Sequence[Any], stations: Sequence[Any] = (), **more: Any) -> str:
    """Return a LIF file of one layout."""
    layout = {"layoutId": "L1", "layoutVersion": "1", "nodes": nodes, "edges": edges, "stations": stations, **more}
    meta = {
        "projectIdentification": "own hall",
        "creator": "test",
        "exportTimestamp": "2026-01-01T00:00:00.00Z",
        "lifVersion": "1.0.0",
    }
    return json.dumps({"metaInformation": meta, "layouts": [layout]})


HALL_NODES = [
    node("N1", 0.0, 0.0),
    node("N2", 5.0, 0.0, actions=[action("pick"), action("drop")]),
    node("N3", 10.0, 0.0),
    node("N4", 10.0, 5.0, actions=[action("pick"), action("drop")]),
    node("N5", 0.0, 5.0, actions=[action("startCharging"), action("stopCharging")]),
]
HALL_EDGES = [edge("N1", "N2"), edge("N2", "N3"), edge("N3", "N4"), edge("N4", "N5"), edge("N5", "N1")]
HALL_STATIONS = [
    {"stationId": "S1", "interactionNodeIds": ["N2"], "stationName": "Goods in"},
    {"stationId": "S2", "interactionNodeIds": ["N4"], "stationName": "Goods out"},
]

OPENTCS = """<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<model version="6.0.0" name="own hall">
  <point name="P-1" positionX="0" positionY="0" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>
  <point name="P-2" positionX="4000" positionY="0" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>
  <point name="P-3" positionX="4000" positionY="3000" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>
  <point name="P-4" positionX="0" positionY="3000" positionZ="0" vehicleOrientationAngle="NaN" type="PARK_POSITION"/>
  <point name="P-5" positionX="8000" positionY="0" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>
  <path name="a" sourcePoint="P-1" destinationPoint="P-2" length="4000" maxVelocity="1000" maxReverseVelocity="0" locked="false"/>
  <path name="b" sourcePoint="P-2" destinationPoint="P-3" length="3300" maxVelocity="500" maxReverseVelocity="0" locked="false">
    <pathLayout connectionType="BEZIER" layerId="0"/>
  </path>
  <path name="c" sourcePoint="P-3" destinationPoint="P-4" length="0" maxVelocity="1000" maxReverseVelocity="0" locked="false"/>
  <path name="d" sourcePoint="P-4" destinationPoint="P-1" length="3000" maxVelocity="1000" maxReverseVelocity="0" locked="false"/>
  <path name="e" sourcePoint="P-2" destinationPoint="P-5" length="4000" maxVelocity="1000" maxReverseVelocity="1000"/>
  <path name="f" sourcePoint="P-1" destinationPoint="P-3" length="5000" maxVelocity="1000" maxReverseVelocity="0" locked="true"/>
  <vehicle name="AGV A" maxVelocity="1000" maxReverseVelocity="500">
    <boundingBox length="1200" width="600" height="500"/>
    <property name="loopback:initialPosition" value="P-4"/>
  </vehicle>
  <vehicle name="AGV-B" maxVelocity="1000" maxReverseVelocity="500"/>
  <locationType name="transfer"><allowedOperation name="LOAD"/></locationType>
  <locationType name="charger"><allowedOperation name="CHARGE"/></locationType>
  <location name="In" positionX="4000" positionY="-500" type="transfer"><link point="P-2"/></location>
  <location name="Out" positionX="8000" positionY="-500" type="transfer"><link point="P-5"/></location>
  <location name="Plug" positionX="0" positionY="4000" type="charger"><link point="P-4"/></location>
  <block name="crossing" type="SINGLE_VEHICLE_ONLY"><member name="P-3"/><member name="e"/></block>
</model>
"""
