"""Versions of the plant: stage a plant file, see what differs and what it breaks, activate it, roll back (docs/layouts.md)."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Annotated, Any, NoReturn

from fastapi import APIRouter, Path, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, Who, answer_of, items, location, read
from app.api.declared import gives
from app.api.inputs import TEXT_PATTERN, Limit, Older, Reason, Strict
from app.api.port import Controller
from app.api.problems import Problem, refused
from app.domain.errors import Refusal
from app.domain.layout import Plant
from app.domain.versions import PlantVersion
from app.plant import Finding, UnusablePlant
from app.plant.difference import Broken
from app.runtime.showing import iso
from app.runtime.versions import Versions

router = APIRouter(prefix="/layout/versions", tags=["layout"])
YAML = "application/yaml"
KINDS = (YAML, "application/x-yaml", "text/yaml", "text/x-yaml", "text/plain")
MOST_FINDINGS = 200
"""Our choice: nobody reads more, and each is some hundred bytes."""
Model = Annotated[str, Path(min_length=1, max_length=100, pattern=TEXT_PATTERN)]
VersionPath = Annotated[int, Path(ge=1, le=(1 << 53) - 1)]
Why = Annotated[
    str, Query(min_length=1, max_length=200, pattern=TEXT_PATTERN, description="Why it is wanted; kept with it.")
]
Against = Annotated[
    int | None, Query(ge=1, le=(1 << 53) - 1, description="Another version; without it, the active one.")
]
_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "The plant file, as YAML in UTF-8.",
        "content": {YAML: {"schema": {"type": "string"}}},
    }
}
_FILE: dict[int | str, dict[str, Any]] = {200: {"description": "The plant file.", "content": {YAML: {}}}}


class ActivateIn(Strict):
    """Why. ``wait``: also if something stands in its way now; it becomes active once nothing does any more.

    ``instead_of``: the version that is active as far as the caller knows; if another one is, nothing is done.
    """

    reason: Reason
    wait: bool = False
    instead_of: Annotated[int, Path(ge=1, le=(1 << 53) - 1)] | None = None


class RejectVersionIn(Strict):
    """Why not."""

    reason: Reason


@router.get("", **gives("PlantVersion[]", description="Newest first."))
async def list_versions(controller: Ctl, after: Older = None, limit: Limit = 100) -> Response:
    """List the versions of the plant; go on with ``after`` = ``next``."""
    rows = await read(_of(controller).store.versions, after, limit)
    return items(map(_shown, rows), rows[-1].number if len(rows) == limit else None)


@router.post("", openapi_extra=_BODY, **gives("StagedVersion", 201, "It is kept; nothing has changed in the plant."))
async def stage_version(request: Request, controller: Ctl, actor: Who, reason: Why) -> Response:
    """Stage a plant file. One with errors is refused with all of them, each with line, column and remedy."""
    versions, text = _of(controller), await _text(request)
    try:
        staged = await versions.stage(controller.plant, text, actor, reason)
    except UnusablePlant as unusable:
        _unusable(unusable)
    if isinstance(staged, Refusal):
        raise refused(staged)
    number = staged.version.number
    body = {**_shown(staged.version), "findings": _findings(staged.findings)}
    return answer_of(body, 201, location("layout", "versions", str(number)))


@router.get("/{version}", **gives("PlantVersion"))
async def get_version(version: VersionPath, controller: Ctl) -> Response:
    """Show one version, without its text."""
    return answer_of(_shown(await _version(controller, version)))


@router.get("/{version}/file", responses=_FILE, response_class=Response)
async def get_version_file(version: VersionPath, controller: Ctl) -> Response:
    """Give the plant file of a version, to the letter."""
    text = await read(_of(controller).store.text, version)
    if text is None:
        await _textless(controller, version)
    name = f'attachment; filename="{_plain(controller.plant.name)}-{version}.yaml"'
    return Response(text, headers={"Content-Disposition": name}, media_type=f"{YAML}; charset=utf-8")


@router.get("/{version}/catalogues/{model}", responses=_FILE, response_class=Response)
async def get_version_catalogue(version: VersionPath, model: Model, controller: Ctl) -> Response:
    """Give the catalogue of a drive model as a version has it, to the letter."""
    source = await read(_of(controller).store.source, version)
    if source is None:
        await _textless(controller, version)
    text = (source.catalogues or {}).get(model)
    if text is None:
        detail = f"Version {version} has no catalogue {model}."
        raise Problem("not-found", detail, f"GET /api/v1/layout/versions/{version} names its models.")
    return Response(text, media_type=f"{YAML}; charset=utf-8")


@router.get("/{version}/findings", **gives("PlantFinding[]", description="Warnings, in the order of the file."))
async def list_version_findings(version: VersionPath, controller: Ctl) -> Response:
    """List what the checker says to a version."""
    await _version(controller, version)
    try:
        found = await _of(controller).findings(version)
    except UnusablePlant as unusable:
        found = unusable.findings
    return items(_findings(found))


@router.get("/{version}/diff", **gives("PlantDifference"))
async def compare_version(version: VersionPath, controller: Ctl, against: Against = None) -> Response:
    """Show what is different in a version, and what that breaks in a plant that has run."""
    versions = _of(controller)
    new = await _plant(controller, version)
    old = controller.plant if against is None else await _plant(controller, against)
    made = await versions.difference(old, new)
    body = {
        "version": version,
        "against": controller.version if against is None else against,
        "changes": [asdict(change) for change in made.changes],
        "breaks": _broken(made.broken),
    }
    return answer_of(body)


@router.get("/{version}/impact", **gives("PlantImpact"))
async def weigh_version(version: VersionPath, controller: Ctl) -> Response:
    """Show what would stand in the way of a version if it became active now, what would be lost, and what has to be taught."""
    impact = await _of(controller).impact(controller.plant, await _plant(controller, version))
    ways = {name: _broken(getattr(impact, name)) for name in ("in_the_way", "lost", "lacking")}
    return answer_of({"version": version, "ready": not impact.in_the_way, **ways})


@router.post("/{version}/activate", **gives("PlantActivation", 202, "It is awaited; the controller changes over."))
async def activate_version(version: VersionPath, body: ActivateIn, controller: Ctl, actor: Person) -> Response:
    """Let a version be the active one; a former one: roll back. Refused, with a list, if it breaks anything under way.

    The controller changes over within seconds: connections are cut, vehicles end what they were granted, jobs go on. Ask
    for the version until it is ``active``; if it is not ``awaited`` any more either, ``note`` says why.
    """
    versions = _of(controller)
    if body.instead_of is not None and body.instead_of != controller.version:
        detail = f"Version {controller.version} is active, not {body.instead_of}."
        raise Problem("stale", detail, "Look at what differs from that one.", "instead_of")
    new = await _plant(controller, version)
    broken = (await versions.impact(controller.plant, new)).in_the_way
    running = controller.plant
    made = await versions.ask(running, version, actor, body.reason, patient=body.wait, in_the_way=broken)
    if isinstance(made, Refusal):
        errors = [{"field": f"{one.what} {one.name}", "message": one.text, "remedy": one.remedy} for one in broken]
        remedy = made.remedy or "See errors for all of it; end that first, or send wait: true."
        raise Problem(made.code, made.reason, remedy, errors=errors if made.code == "not-now" else ())
    headers = location("layout", "versions", str(version))
    return answer_of({"version": _shown(made), "in_the_way": _broken(broken)}, 202, headers)


@router.post("/{version}/reject", **gives("PlantVersion"))
async def reject_version(version: VersionPath, body: RejectVersionIn, controller: Ctl, actor: Person) -> Response:
    """Let a staged or awaited version not become active. A former one that is awaited stays a former one."""
    made = await _of(controller).reject(controller.plant, version, actor, body.reason)
    if isinstance(made, Refusal):
        raise refused(made)
    return answer_of(_shown(made))


def _of(controller: Controller) -> Versions:
    if controller.versions is None:
        remedy = "Start it with hoistway serve, on a database in a file or a server."
        raise Problem("not-now", "This server keeps no versions of the plant.", remedy)
    return controller.versions


async def _text(request: Request) -> str:
    kind = request.headers.get("content-type", "")
    if kind.partition(";")[0].strip().lower() not in KINDS:
        raise Problem("media-type", f"The body came as {kind[:80]!r}.", f"Send the header Content-Type: {YAML}.")
    body = await request.body()
    try:
        return body.decode("utf-8-sig")
    except UnicodeDecodeError as wrong:
        detail = f"The plant file is not UTF-8: {wrong.reason} at byte {wrong.start}."
        raise Problem("malformed", detail, "Save it as UTF-8.") from None


async def _version(controller: Controller, number: int) -> PlantVersion:
    return await read(_of(controller).store.version, number) or _none(number)


async def _plant(controller: Controller, number: int) -> Plant:
    try:
        return await _of(controller).plant(number) or await _textless(controller, number)
    except UnusablePlant as unusable:
        remedy = "Stage a file that this program understands."
        detail = f"Version {number} cannot be used by this program: {unusable.message}."
        raise Problem("conflict", detail, remedy) from None


async def _textless(controller: Controller, number: int) -> NoReturn:
    """There is no text of a version: there is no such version, or it was thrown away."""
    version = await _version(controller, number)
    detail = f"The text of version {number} is not kept any more; it was rejected: {version.note}."
    raise Problem("not-found", detail, "Stage it again, if somebody has it and it is wanted after all.")


def _none(number: int) -> NoReturn:
    raise Problem("not-found", f"There is no version {number} of the plant.", "GET /api/v1/layout/versions lists them.")


def _unusable(unusable: UnusablePlant) -> NoReturn:
    errors = [finding for finding in unusable.findings if finding.is_error]
    first = errors[0]
    many = f"{len(errors)} error{'s' * (len(errors) > 1)}"
    detail = f"The plant file has {many}; line {first.line}, column {first.column}: {first.message}."
    shown = [{"field": one.pop("path"), **one} for one in _findings(unusable.findings)]
    remedy = first.remedy or "Correct the plant file, and look at it with hoistway check."
    raise Problem("invalid", detail, remedy, first.path, shown) from None


def _findings(found: Sequence[Finding]) -> list[dict[str, object]]:
    ordered = sorted(found, key=lambda finding: not finding.is_error)[:MOST_FINDINGS]
    return [{**asdict(finding), "severity": finding.severity.value} for finding in ordered]


def _broken(found: Iterable[Broken]) -> list[dict[str, object]]:
    return [asdict(one) for one in found]


def _shown(version: PlantVersion) -> dict[str, object]:
    plain = {**asdict(version), "state": version.state.value, "origin": version.origin.value}
    moments = {name: plain[name] for name in ("at", "activated", "asked", "ran", "rejected", "pruned")}
    return {**plain, **{name: None if moment is None else iso(moment) for name, moment in moments.items()}}


def _plain(name: str) -> str:
    return "".join(letter if letter.isascii() and (letter.isalnum() or letter in "-_") else "_" for letter in name)
