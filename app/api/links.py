"""Links: the lines that carry several devices, how they are doing, and what was last on them."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_view, items, missing, read
from app.api.declared import gives
from app.api.drive_inputs import Wait
from app.api.inputs import PathId
from app.api.link_frames import frames_of_link
from app.api.operations import TAKEN, taken
from app.domain import drive_requests as r
from app.domain.ids import LinkId
from app.runtime.showing import shown

router = APIRouter(prefix="/links", tags=["links"])


@router.get("", **gives("Line[]", description="All links, as they are now."))
async def list_links(controller: Ctl) -> Response:
    """List the lines that carry several devices: connected or not, since when, why not, and their figures."""
    return items(shown(view) for view in controller.links())


@router.get("/{link}", **gives("Line"))
async def get_link(link: PathId, controller: Ctl) -> Response:
    """Show one link."""
    view = next((view for view in controller.links() if view.id == link), None)
    return answer_view(view) if view is not None else missing("link", link)


@router.get("/{link}/frames", **gives("Frame[]", description="The last traffic on it, oldest first."))
async def get_link_frames(
    link: PathId, controller: Ctl, lang: Annotated[Literal["en", "ko"], Query()] = "en"
) -> Response:
    """Show the last packets on a link, explained."""
    spec = controller.plant.link(LinkId(link))
    if spec is None:
        missing("link", link)
    return items(await read(frames_of_link, spec, list(controller.link_frames(spec.id)), lang))


@router.post("/{link}/stop", **TAKEN)
async def stop_drives(link: PathId, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Stop all drives of a line at once, by one packet that none of them answers."""
    return await taken(controller, r.StopDriveLine(actor, LinkId(link)), wait)
