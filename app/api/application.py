"""The application: guard, routers, problems, probes, page and docs put together."""

import importlib.util
from pathlib import Path

from fastapi import APIRouter, FastAPI, Request
from fastapi.openapi.docs import get_swagger_ui_html
from starlette.middleware import Middleware
from starlette.middleware.errors import ServerErrorMiddleware
from starlette.responses import FileResponse, HTMLResponse, RedirectResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api import (
    accounts,
    alarms,
    audit,
    closures,
    devices,
    drive_backups,
    drive_jog,
    drive_parameters,
    drives,
    emergency,
    events,
    history,
    jobs,
    links,
    live,
    metrics,
    operations,
    plant,
    problems,
    sessions,
    stations,
    statistics,
    taught,
    taught_files,
    teaching,
    vehicles,
    versions,
    walks,
    webhooks,
    zones,
)
from app.api.callers import Callers
from app.api.calls import Ctl, answer_of
from app.api.calls_counted import CountedCalls
from app.api.commands import COMMANDS
from app.api.declared import Raw, declare, gives
from app.api.guard import Guard
from app.api.orders import PATH, Orders
from app.api.policy import Policy
from app.api.port import Controller
from app.api.queries import Names, Queries
from app.domain.view import Topic
from app.settings import Settings

VERSION = "0.1.0"
PAGE = Path(__file__).parent.parent / "web"
PAGE_HEADERS = {
    "Content-Security-Policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
    "connect-src 'self'; object-src 'none'; frame-ancestors 'none'; base-uri 'none'; form-action 'self'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
}

probes = APIRouter(tags=["probes"])


@probes.get("/healthz", **gives("Health", description="The server runs."))
async def healthz() -> Response:
    """Say that the server runs."""
    return answer_of({"status": "ok"})


@probes.get("/readyz", **gives("Readiness", 200, "Whether it can take jobs; 503 if not.", Readiness=503))
async def readyz(controller: Ctl) -> Response:
    """Say whether the controller can take jobs, and why not."""
    reasons = [controller.trouble] if controller.trouble else []
    if not controller.model.all(Topic.CONTROLLER):
        reasons.append("The controller is starting.")
    return answer_of({"ready": not reasons, "reasons": reasons}, 503 if reasons else 200)


class Api(FastAPI):
    """FastAPI, with orders answered before its own layers."""

    orders: ASGIApp
    counted: CountedCalls

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if Orders.take(scope):
            await self.counted(self.orders, PATH, scope, receive, send)
        elif scope["type"] == "http":
            await self.counted(super().__call__, "", scope, receive, send)
        else:
            await super().__call__(scope, receive, send)


def application(controller: Controller, settings: Settings) -> FastAPI:
    """Return the ASGI application around a running controller."""
    app = described(settings)
    app.state.controller = controller
    if controller.reception is not None:
        callers: Callers = app.state.callers
        callers.register = controller.reception.access
        controller.reception.access.on_look = callers.look
    return app


def described(settings: Settings) -> FastAPI:
    """Return the application without a controller: enough for its description."""
    callers = Callers(settings)
    app = Api(
        title="Hoistway",
        version=VERSION,
        openapi_url="/api/openapi.json",
        docs_url=None,
        redoc_url=None,
        redirect_slashes=False,
        generate_unique_id_function=lambda route: route.name,
        default_response_class=Raw,
        middleware=[Middleware(Guard, settings=settings, callers=callers), Middleware(Queries)],
    )
    app.state.settings = settings
    app.state.callers = callers
    app.counted = app.state.counted = CountedCalls()
    app.orders = ServerErrorMiddleware(Orders(Guard(app, settings, callers), app.state), problems.defect)
    api = APIRouter()
    for router in (
        jobs.router,
        events.router,
        vehicles.router,
        stations.router,
        stations.carriers,
        drives.router,
        drive_parameters.router,
        drive_parameters.watches,
        drive_parameters.readings,
        drive_backups.router,
        drive_jog.router,
        operations.router,
        links.router,
        teaching.router,
        taught.router,
        taught.roll_backs,
        taught_files.router,
        devices.router,
        emergency.router,
        closures.router,
        history.router,
        statistics.router,
        walks.router,
        alarms.router,
        zones.router,
        plant.controller_routes,
        plant.layout,
        versions.router,
        audit.router,
        sessions.router,
        accounts.users,
        accounts.keys,
        plant.problems,
        live.router,
        webhooks.router,
    ):
        api.include_router(router)
    # A router without a prefix is looked through when it is included, and all its routes are made once for that.
    app.include_router(api, prefix="/api/v1")
    app.include_router(probes)
    app.include_router(metrics.router)
    problems.install(app)
    declare(app)
    _serve_docs(app)
    _serve_page(app)
    app.add_api_websocket_route("/{path:path}", problems.no_stream)
    callers.policy = Policy(app.routes, COMMANDS)
    app.state.queries = Names(app.routes)
    return app


def _serve_docs(app: FastAPI) -> None:
    """Swagger UI without internet: its files come with a Python package."""
    spec = importlib.util.find_spec("fastapi_offline")
    if spec is None or spec.origin is None:
        return
    app.mount("/api/docs/files", StaticFiles(directory=Path(spec.origin).parent / "static"), name="docs")

    async def docs(_request: Request) -> HTMLResponse:
        return get_swagger_ui_html(
            openapi_url="/api/openapi.json",
            title="Hoistway API",
            swagger_js_url="/api/docs/files/swagger-ui-bundle.js",
            swagger_css_url="/api/docs/files/swagger-ui.css",
            swagger_favicon_url="/api/docs/files/favicon.png",
        )

    app.add_route("/api/docs", docs, include_in_schema=False)
    app.add_route("/docs", lambda _request: RedirectResponse("/api/docs"), include_in_schema=False)


def _serve_page(app: FastAPI) -> None:
    if not (PAGE / "index.html").is_file():
        return

    async def page(_request: Request) -> FileResponse:
        return FileResponse(PAGE / "index.html", headers=PAGE_HEADERS)

    app.add_route("/", page, include_in_schema=False)
    if (PAGE / "assets").is_dir():
        app.mount("/assets", StaticFiles(directory=PAGE / "assets"), name="page")
