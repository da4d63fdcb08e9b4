"""A client of the application around a scripted controller, all in one loop."""

from collections.abc import AsyncIterator

import httpx
import pytest
from fastapi import FastAPI

from app.api.application import described
from app.settings import Settings
from tests.api.scripted import Scripted


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
def controller() -> Scripted:
    return Scripted()


@pytest.fixture(scope="session")
def described_app() -> FastAPI:
    return described(Settings())


@pytest.fixture
def served(controller: Scripted, described_app: FastAPI) -> FastAPI:
    described_app.state.controller = controller
    described_app.state.layout = None
    return described_app


@pytest.fixture
async def client(served: FastAPI) -> AsyncIterator[httpx.AsyncClient]:
    transport = httpx.ASGITransport(served, raise_app_exceptions=False)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1") as client:
        yield client
