"""The server's certificate: refused before the start if it cannot be used, and taken anew when its file changes."""

import asyncio
import ssl
from collections.abc import MutableMapping
from pathlib import Path

import pytest
import structlog
import trustme

from app.cli.plainly import CannotStart
from app.cli.running import url_of
from app.cli.tls import context_of, renewed
from app.settings import Settings, SettingsError, load
from tests.runtime.peers import settled


@pytest.fixture(scope="module")
def authority() -> trustme.CA:
    return trustme.CA()


def written(authority: trustme.CA, file: Path, name: str = "127.0.0.1") -> Path:
    """A certificate and its key in one file."""
    authority.issue_cert(name).private_key_and_cert_chain_pem.write_to_path(str(file))
    return file


def settings(certificate: Path | None, key: Path | None = None) -> Settings:
    return load(None, {}, tls_certificate=certificate, tls_key=key)


def test_without_a_certificate_nothing_is_asked_of_the_server() -> None:
    assert context_of(settings(None)) is None
    assert url_of("0.0.0.0", 80) == "http://127.0.0.1:80"


def test_a_certificate_with_its_key_is_handed_on(authority: trustme.CA, tmp_path: Path) -> None:
    file = written(authority, tmp_path / "both.pem")
    assert context_of(settings(file)) is not None
    assert url_of("::1", 443, tls=True) == "https://[::1]:443"


def test_a_key_without_a_certificate_is_no_setting(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="tls_key needs tls_certificate"):
        settings(None, tmp_path / "key.pem")


@pytest.mark.parametrize(
    "content", [b"", b"lot,from,to\n", b"-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n"]
)
def test_what_is_no_certificate_is_refused_with_a_remedy(content: bytes, tmp_path: Path) -> None:
    file = tmp_path / "wrong.pem"
    file.write_bytes(content)
    with pytest.raises(CannotStart, match="cannot be used") as caught:
        context_of(settings(file))
    assert "PEM" in caught.value.remedy


def test_a_file_that_is_not_there_is_named(authority: trustme.CA, tmp_path: Path) -> None:
    with pytest.raises(CannotStart, match=r"none\.pem cannot be read: No such file"):
        context_of(settings(written(authority, tmp_path / "both.pem"), tmp_path / "none.pem"))


def test_the_key_of_another_certificate_is_refused(authority: trustme.CA, tmp_path: Path) -> None:
    other = tmp_path / "other.pem"
    authority.issue_cert("127.0.0.1").private_key_pem.write_to_path(str(other))
    with pytest.raises(CannotStart, match="cannot be used"):
        context_of(settings(written(authority, tmp_path / "both.pem"), other))


def test_a_new_certificate_is_taken_while_the_server_runs_and_a_wrong_one_is_not(
    authority: trustme.CA, tmp_path: Path
) -> None:
    file = written(authority, tmp_path / "both.pem", "old.example")
    context = context_of(settings(file))
    told: list[str] = []

    def noted(_logger: object, _level: str, event: MutableMapping[str, object]) -> str:
        told.append(str(event["event"]))
        raise structlog.DropEvent

    async def names_seen_until(changed: str) -> None:
        server = await asyncio.start_server(lambda _, writer: writer.close(), "127.0.0.1", 0, ssl=context)
        log = structlog.wrap_logger(None, processors=[noted])
        task = asyncio.create_task(renewed(context, settings(file), log, every=0.001))
        port = server.sockets[0].getsockname()[1]
        try:
            assert await subject(port, authority, "old.example") is None
            await asyncio.sleep(0)
            # The certificate is new already, and its key the old one: whoever renews them writes one after the other.
            key = file.read_text().partition("-----BEGIN CERT")[0]
            other = written(authority, tmp_path / "other.pem", changed).read_text()
            file.write_text(key + other[other.index("-----BEGIN CERT") :])
            while not told:
                await asyncio.sleep(0.001)
            assert await subject(port, authority, "old.example") is None
            written(authority, file, changed)
            while len(told) < 2:
                await asyncio.sleep(0.001)
            assert await subject(port, authority, changed) is None
            assert await subject(port, authority, "old.example") is not None
        finally:
            task.cancel()
            server.close()
            await settled()

    asyncio.run(names_seen_until("new.example"))
    assert told == ["the certificate is not taken anew", "the certificate was taken anew"]


async def subject(port: int, authority: trustme.CA, name: str) -> str | None:
    """Connect as somebody who wants that name; return what was wrong with it, None if nothing."""
    context = ssl.create_default_context()
    authority.configure_trust(context)
    try:
        _, writer = await asyncio.open_connection("127.0.0.1", port, ssl=context, server_hostname=name)
    except ssl.SSLCertVerificationError as wrong:
        return wrong.verify_message
    writer.close()
    return None
