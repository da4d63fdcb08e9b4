"""A server with a certificate: REST and live stream over TLS, and nothing without."""

import asyncio
import json
import ssl
from pathlib import Path

import httpx
import pytest
import trustme
from websockets.asyncio.client import connect

from tests.e2e.processes import GENEROUS, free_ports, quick_plant, running, wait_until


def test_everything_goes_over_tls_where_a_certificate_is_given(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    authority = trustme.CA()
    certificate, log = tmp_path / "both.pem", tmp_path / "log"
    authority.issue_cert("127.0.0.1").private_key_and_cert_chain_pem.write_to_path(str(certificate))
    trusting = ssl.create_default_context()
    authority.configure_trust(trusting)
    monkeypatch.setenv("HOISTWAY_TLS_CERTIFICATE", str(certificate))
    (port,) = free_ports(1)
    plant, database = str(quick_plant("small", tmp_path)), f"sqlite:///{tmp_path / 'plant.db'}"

    async def first_word() -> str:
        async with connect(f"wss://127.0.0.1:{port}/api/v1/live", ssl=trusting) as watching:
            await watching.send(json.dumps({"type": "subscribe", "topics": ["controller"]}))
            return str(await watching.recv())

    with (
        running("serve", "--plant", plant, "--database", database, "--port", str(port), log=log),
        httpx.Client(base_url=f"https://127.0.0.1:{port}", verify=trusting, timeout=GENEROUS) as client,
    ):
        wait_until(lambda: f"https://127.0.0.1:{port}" in log.read_text(), "the server", log)
        page = client.get("/")
        assert page.status_code == 200
        assert {vehicle["id"] for vehicle in client.get("/api/v1/vehicles").json()["items"]} == {"V001", "V002"}
        order = client.post("/api/v1/jobs", json={"source": "P1", "destination": "P2"})
        assert order.status_code == 201, order.text
        assert json.loads(asyncio.run(first_word()))
        with pytest.raises(httpx.HTTPError):
            httpx.get(f"http://127.0.0.1:{port}/healthz", trust_env=False)
