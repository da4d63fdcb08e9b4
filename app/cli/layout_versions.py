"""``hoistway layout stage | versions | get | activate | reject | rollback``: the versions of a running plant, over REST."""

from __future__ import annotations

import getpass
import json as jsons
import os
import re
import time
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from app.cli.catalogues import DIRECTORY
from app.cli.layout_look import change_line, named
from app.cli.plainly import CannotStart, plainly, refuse, spared, text_of, why_not
from app.cli.tongue import language, say, told_here
from app.domain.errors import HoistwayError
from app.domain.versions import Source

if TYPE_CHECKING:
    import httpx

Url = Annotated[str, typer.Option(help="where the controller is", envvar="HOISTWAY_URL")]
Reason = Annotated[str, typer.Option(help="why; kept with it")]
Number = Annotated[int, typer.Argument(help="of the version", min=1)]
Json = Annotated[bool, typer.Option("--json", help="print what the server answers")]
VERSIONS = "/versions"
HERE = "http://127.0.0.1:8080"
WITHIN, PAUSE = 60.0, 0.25
"""Seconds for an answer, and between two looks whether the plant has changed. Our choice."""


class Refused(HoistwayError):
    """The server did not do it; the message says why."""

    code = "refused"


class Server:
    """The REST interface of a controller. Every call raises Refused, or CannotStart: nobody answers there."""

    def __init__(self, client: httpx.Client) -> None:
        self._client = client

    def ask(self, method: str, path: str, **more: Any) -> httpx.Response:
        """Ask, and return the answer."""
        import httpx

        try:
            answer = self._client.request(method, path, **more)
        except (httpx.HTTPError, httpx.InvalidURL) as wrong:
            raise CannotStart(
                f"{self._client.base_url} does not answer: {why_not(wrong)}",
                remedy=f"Name it with --url, such as {HERE}.",
            ) from None
        if answer.is_success:
            return answer
        raise _refused(answer)

    def active(self) -> dict[str, Any]:
        """Return the active version, looking through all of them from the newest on."""
        after: dict[str, int] = {}
        while True:
            page = self.ask("GET", VERSIONS, params={"limit": 1000, **after}).json()
            found: dict[str, Any] | None = next((one for one in page["items"] if one["state"] == "active"), None)
            if found is not None:
                return found
            if page["next"] is None:
                raise Refused("no version is active", remedy="Ask again: the controller changes over.")
            after = {"after": page["next"]}

    def version(self, number: int) -> dict[str, Any]:
        """Return a version; while the controller changes over, wait."""
        for _ in range(int(WITHIN / PAUSE)):
            try:
                found: dict[str, Any] = self.ask("GET", f"{VERSIONS}/{number}").json()
            except CannotStart:
                time.sleep(PAUSE)
            else:
                return found
        raise CannotStart("the controller does not answer any more", remedy="See its log.")


@contextmanager
def _server(url: str) -> Iterator[Server]:
    """Give the server of a URL; what it refuses ends the command."""
    with plainly(), connected(url) as server:
        yield server


@contextmanager
def connected(url: str, within: float = WITHIN) -> Iterator[Server]:
    """Give the server of a URL, which has so many seconds for an answer.

    The key, where one is wanted, is in HOISTWAY_KEY: on a command line everybody could read it.
    Raises CannotStart: it is no URL.
    """
    import httpx

    headers = {"X-Actor": getpass.getuser(), "Accept": "application/json", "Accept-Language": language()}
    if key := os.environ.get("HOISTWAY_KEY"):
        headers["Authorization"] = f"Bearer {key}"
    if not url.startswith(("http://", "https://")):
        raise CannotStart(f"{url} is no URL", remedy=f"Write it like {HERE}.")
    base = url.rstrip("/") + "/api/v1/layout"
    with httpx.Client(base_url=base, headers=headers, timeout=within, trust_env=False) as client:
        yield Server(client)


def stage(
    file: Annotated[Path, typer.Argument(help="the plant file")],
    reason: Reason,
    url: Url = HERE,
    *,
    json: Json = False,
) -> None:
    """Give a plant file to the controller as a new version: nothing changes yet. Prints what differs and what stands in the way.

    Exit 0: it is staged, and nothing stands in its way. 1: something does, or it is refused.
    """
    with _server(url) as server:
        sent = {"content": text_of(file).encode(), "headers": {"Content-Type": "application/yaml"}}
        made = server.ask("POST", VERSIONS, params={"reason": reason}, **sent).json()
        number = made["number"]
        impact = server.ask("GET", f"{VERSIONS}/{number}/impact").json()
        change = server.ask("GET", f"{VERSIONS}/{number}/diff").json()
        if json:
            print(jsons.dumps({"version": made, "diff": change, "impact": impact}, ensure_ascii=False))
        else:
            for finding in made["findings"]:
                place = f"{file}:{finding['line']}:{finding['column']}"
                print(f"{place}: {told_here(finding['severity'])}: {told_here(finding['message'])}")
            _show_change(change, impact)
            say(f"version {number} is staged: hoistway layout activate {number} --reason WHY")
        if not impact["ready"]:
            raise typer.Exit(1)


def versions(url: Url = HERE, *, json: Json = False) -> None:
    """Show the versions of the plant, newest first."""
    with _server(url) as server:
        found = server.ask("GET", VERSIONS, params={"limit": 1000}).json()
        if json:
            print(jsons.dumps(found, ensure_ascii=False))
            return
        for one in found["items"]:
            for line in rows_of(one):
                print(line)


def rows_of(one: Mapping[str, Any]) -> Iterator[str]:
    """Give the lines of a version: its state, with when, by whom and why it came to that, and below why it was staged."""
    from rich.cells import cell_len

    since, who, why = one["activated"] or one["at"], one["activated_by"] or one["actor"], one["why"] or one["reason"]
    note = one["note"]
    if one["state"] == "awaited":
        since, who, why = one["asked"], one["asked_by"], one["asked_why"]
    elif one["state"] == "rejected" and note:
        person, _, reason = note.partition(": ")
        since, who, why, note = one["rejected"], person if reason else "", reason or note, ""
    state = told_here(one["state"])
    yield f"{one['number']:>5}  {state}{' ' * (9 - cell_len(state))}{_moment(since)}  {who:<20}  {why}"
    if why != one["reason"] or who != one["actor"]:
        yield "       " + told_here(f"staged by {one['actor']} at {_moment(one['at'])}: {one['reason']}")
    if note:
        yield f"       {told_here(note)}"


def _moment(at: str) -> str:
    return f"{at[:16].replace('T', ' ')}Z"


def get(
    number: Annotated[int | None, typer.Argument(help="of the version; without it, the active one", min=1)] = None,
    *,
    output: Annotated[Path, typer.Option("--output", "-o", help="where to")],
    url: Url = HERE,
    database: Annotated[
        str | None, typer.Option(help="SQLAlchemy URL: read it there, whether a controller runs or not")
    ] = None,
    catalogues: Annotated[
        bool, typer.Option("--catalogues", help="also the catalogues of its drives, into the directory beside it")
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="write over files that are there")] = False,
) -> None:
    """Write the plant file of a version, to the letter."""
    if database is not None:
        with plainly():
            source = _kept(database, number)
    else:
        with _server(url) as server:
            source = _asked(server, number)
    models = source.catalogues or {}
    written = {output.parent / DIRECTORY / f"{model}.yaml": text for model, text in models.items() if catalogues}
    with plainly():
        spared({output: source.text, **written}, force=force)
    for file, text in {output: source.text, **written}.items():
        _write(file, text)
    if models and not catalogues:
        say(f"the version has catalogues of its own ({', '.join(models)}): --catalogues writes them too")


def _asked(server: Server, number: int | None) -> Source:
    """Return what a version is made of, as a controller says."""
    if number is None:
        number = server.active()["number"]
    text = server.ask("GET", f"{VERSIONS}/{number}/file").text
    models = server.version(number)["models"]
    paths = {model: f"{VERSIONS}/{number}/catalogues/{model}" for model in models}
    return Source(text, {model: server.ask("GET", path).text for model, path in paths.items()})


def _kept(database: str, number: int | None) -> Source:
    """Return what a version is made of, as the database has it. Raises StoreError, CannotStart: it has none."""
    from app.store.opening import revision
    from app.store.schema import newest
    from app.store.versions import VersionStore

    if revision(database) != newest():
        raise CannotStart("the database keeps no versions of a plant", remedy="Start the controller on it once.")
    with closing(VersionStore(database)) as store:
        active = store.active()
        wanted = number if number is not None or active is None else active.number
        source = None if wanted is None else store.source(wanted)
    if source is None:
        raise CannotStart("the database does not keep the text of that version")
    return source


def _write(file: Path, text: str) -> None:
    try:
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(text.encode())
    except OSError as wrong:
        refuse(f"{file} cannot be written: {wrong.strerror}")


def activate(
    number: Number,
    reason: Reason,
    url: Url = HERE,
    *,
    wait: Annotated[
        bool, typer.Option("--wait", help="until nothing stands in its way; Ctrl-C leaves it awaited")
    ] = False,
) -> None:
    """Let a version be the active one, without losing jobs. Refused, with a list, if it breaks anything under way.

    Exit 0: it is active. 1: it is not, and why.
    """
    with _server(url) as server:
        _activate(server, number, reason, wait=wait)


def rollback(
    reason: Reason,
    url: Url = HERE,
    *,
    wait: Annotated[bool, typer.Option("--wait", help="until nothing stands in its way")] = False,
) -> None:
    """Activate the version that was active before the present one; the same rules hold."""
    with _server(url) as server:
        active = server.active()
        if active["before"] is None:
            refuse(f"version {active['number']} is the first: there is nothing to roll back to")
        _activate(server, active["before"], reason, wait=wait, instead_of=active["number"])


def reject(number: Number, reason: Reason, url: Url = HERE) -> None:
    """Let a staged or awaited version not become active."""
    with _server(url) as server:
        made = server.ask("POST", f"{VERSIONS}/{number}/reject", json={"reason": reason}).json()
        say(f"version {number} is {told_here(made['state'])}")


def _activate(server: Server, number: int, reason: str, *, wait: bool, instead_of: int | None = None) -> None:
    body = {"reason": reason, "wait": wait} | ({} if instead_of is None else {"instead_of": instead_of})
    made = server.ask("POST", f"{VERSIONS}/{number}/activate", json=body).json()
    for one in made["in_the_way"]:
        print(f"{told_here('waits for')}: {told_here(one['what'])} {named(one['name'])}: {told_here(one['text'])}")
    kept = told_here(f"version {number} stays awaited, and becomes active once nothing is in its way")
    withdraw = told_here(f"to withdraw it: hoistway layout reject {number} --reason WHY")
    if made["in_the_way"]:
        print(f"{kept}{told_here(', also after Ctrl-C')}: {withdraw}", flush=True)
    try:
        while (found := server.version(number))["state"] == "awaited":
            time.sleep(PAUSE)
    except KeyboardInterrupt:
        print(f"\n{kept}: {withdraw}", flush=True)
        raise typer.Exit(130) from None
    if found["state"] != "active":
        refuse(f"version {number} is {told_here(found['state'])}: {told_here(found['note'])}")
    say(f"version {number} is active")


def _show_change(change: Mapping[str, Any], impact: Mapping[str, Any]) -> None:
    for one in change["changes"]:
        print(change_line(one["what"], one["name"], one["how"], one["text"]))
    ways = (("in the way", "in_the_way"), ("lost", "lost"), ("to be taught", "lacking"))
    for word, found in ((word, impact.get(name, ())) for word, name in ways):
        for one in found:
            print(f"{told_here(word)}: {told_here(one['what'])} {named(one['name'])}: {told_here(one['text'])}")
            if one["remedy"]:
                print(f"    {told_here(one['remedy'])}")
    if not change["changes"]:
        say("no difference to the plant that runs")


def _refused(answer: httpx.Response) -> Refused:
    try:
        problem = answer.json()
    except ValueError:
        problem = {}
    said = problem.get("detail") or f"{answer.status_code} {answer.reason_phrase}"
    errors = problem.get("errors", ())
    told = {error.get("remedy") for error in errors}
    remedy = problem.get("remedy", "")
    lines = [said, *(_line(error) for error in errors)]
    return Refused(_typed("\n  ".join(lines)), remedy="" if remedy in told else _typed(remedy))


_TYPED = (
    (re.compile(r"POST /api/v1/layout/versions/(\d+)/reject"), r"hoistway layout reject \1 --reason WHY"),
    (re.compile(r"GET /api/v1/layout/versions\b"), "hoistway layout versions"),
    (re.compile(r"send wait: true"), "use --wait"),
    (re.compile(r"wait: true를 (보내|붙이)"), "--wait를 붙이"),
)
"""What a refusal says over REST, and what one types here."""


def _typed(words: str) -> str:
    for said, typed in _TYPED:
        words = said.sub(typed, words)
    return words


def _line(error: Mapping[str, Any]) -> str:
    place = error.get("field", "")
    if "line" in error:
        place = f"{error['line']}:{error['column']}: {told_here(error.get('severity', 'error'))}"
    remedy = f"; {error['remedy']}" if error.get("remedy") else ""
    return f"{place}: {error['message']}{remedy}"
