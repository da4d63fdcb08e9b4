"""A client of the application around a scripted controller, all in one loop."""

from collections.abc import AsyncIterator

import httpx
import pytest

from app.api import application
from app.settings import Settings
from tests.api.scripted import Scripted


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
def controller() -> Scripted:
    return Scripted()


@pytest.fixture
async def client(controller: Scripted) -> AsyncIterator[httpx.AsyncClient]:
    transport = httpx.ASGITransport(application(controller, Settings()), raise_app_exceptions=False)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1") as client:
        yield client
