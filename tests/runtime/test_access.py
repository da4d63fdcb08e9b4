"""Who is known, in memory: looked up with each request, seen soon when the command line changes it."""

import asyncio
from collections.abc import AsyncIterator, Callable
from pathlib import Path

import pytest

from app.domain.access import Caller, Key, Role
from app.runtime import access as access_module
from app.runtime.access import Access, digest_of, drawn
from app.runtime.passwords import Passwords, trouble_with
from app.runtime.reception import Given, Reception
from app.store.access import AccessStore
from tests.api.receptions import CHEAP, PASSWORD, ROOT, Hand, made, reception, with_admin

pytestmark = pytest.mark.anyio
MES = frozenset({Role.MES})


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
def clock() -> Hand:
    return Hand()


@pytest.fixture
async def desk(tmp_path: Path, clock: Hand) -> AsyncIterator[Reception]:
    async with reception(tmp_path, clock) as desk:
        yield desk


async def given_key(desk: Reception, name: str = "mes") -> bytes:
    key = await desk.add_key(name, MES, None, ROOT)
    assert isinstance(key, str)
    return key.encode()


async def test_a_key_is_known_by_its_digest_alone(desk: Reception) -> None:
    key = await given_key(desk)
    access = desk.access
    assert access.caller(key) == access.caller(key) == Caller("mes", MES, person=False, held="key mes")
    for other in (key[:-1], key + b"a", key.upper(), b"", digest_of(access.known.secret, key).encode()):
        assert access.caller(other) is None


async def until(said: Callable[[], bool]) -> None:
    async with asyncio.timeout(60):
        while not said():
            await asyncio.sleep(0)


async def test_no_two_keys_are_alike() -> None:
    assert len({drawn("hwk_") for _ in range(100)}) == 100


async def test_what_the_command_line_changes_is_seen_at_the_next_look(
    desk: Reception, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, clock: Hand
) -> None:
    monkeypatch.setattr(access_module, "LOOK_EVERY", 0.0)
    beside = AccessStore(f"sqlite:///{tmp_path}/access.db", lambda n: b"\0" * n)
    secret = beside.load().secret
    key = Key("line", MES, digest_of(secret, b"hwk_x"), clock.utc(), ROOT)
    access = Access(beside, clock)
    await access.start()
    assert not access.closed
    other = AccessStore(f"sqlite:///{tmp_path}/access.db", lambda n: b"\0" * n)
    other.add_key(key)
    await until(lambda: access.caller(b"hwk_x") is not None)
    other.revoke_key("line", ROOT, clock.utc())
    await until(lambda: access.caller(b"hwk_x") is None)
    await until(lambda: access.closed)
    other.close()
    await access.stop()


async def test_the_last_use_of_a_key_is_written_down_when_the_server_stops(tmp_path: Path, clock: Hand) -> None:
    async with reception(tmp_path, clock) as desk:
        key = await given_key(desk)
        await given_key(desk, "unused")
        clock.at += 90
        desk.access.caller(key)
    kept = made(f"sqlite:///{tmp_path}/access.db")
    assert {one.name: one.used for one in kept.load().keys} == {"mes": clock.at, "unused": None}
    kept.close()


async def test_people_and_keys_are_still_known_after_a_restart(tmp_path: Path, clock: Hand) -> None:
    async with reception(tmp_path, clock) as desk:
        await with_admin(desk)
        key = await given_key(desk)
        given = await desk.log_in("kim", PASSWORD, "10.0.0.1")
        assert isinstance(given, Given)
    async with reception(tmp_path, clock) as desk:
        assert desk.access.caller(key) is not None
        caller = desk.access.caller(given.token.encode())
        assert caller is not None
        assert (caller.name, caller.person) == ("kim", True)


async def test_a_password_kept_with_cheaper_parameters_is_hashed_anew_at_the_next_log_in(desk: Reception) -> None:
    await with_admin(desk)
    before = desk.users[0].password
    stronger = Reception(desk.access, Passwords(type(CHEAP)(time_cost=2, memory_cost=8, parallelism=1)))
    assert isinstance(await stronger.log_in("kim", PASSWORD, "10.0.0.1"), Given)
    assert desk.users[0].password != before
    assert "t=2" in desk.users[0].password
    assert isinstance(await stronger.log_in("kim", PASSWORD, "10.0.0.1"), Given)


async def test_many_attempts_at_once_are_no_way_round_the_throttle(desk: Reception) -> None:
    await with_admin(desk)
    tries = (desk.log_in("kim", f"guess number {n}", "10.0.0.1") for n in range(40))
    looked_at = [answer for answer in await asyncio.gather(*tries) if type(answer).__name__ == "Refusal"]
    assert len(looked_at) == 5


def test_passwords_are_argon2id_and_compared_in_whole() -> None:
    passwords = Passwords(CHEAP)
    kept = passwords.hashed(PASSWORD)
    assert kept.startswith("$argon2id$")
    assert passwords.same(kept, PASSWORD)
    assert not passwords.same(kept, PASSWORD + " ")
    assert not passwords.same(None, PASSWORD)
    assert not passwords.same("no hash", PASSWORD)
    assert Passwords().stale(kept)


@pytest.mark.parametrize("password", ["123456789", "kim and more", "aaaabbbbccccdddd", "x" * 201])
def test_a_password_that_is_guessed_soon_is_refused(password: str) -> None:
    assert trouble_with(password, "kim")
    assert not trouble_with(PASSWORD, "kim")
