"""Where webhooks may lead: only to what the settings name, however a name resolves (server-side request forgery)."""

import asyncio
import ipaddress
import re
from collections.abc import Awaitable, Callable, Sequence
from urllib.parse import urlsplit

from app.domain.errors import HoistwayError

Address = ipaddress.IPv4Address | ipaddress.IPv6Address
Network = ipaddress.IPv4Network | ipaddress.IPv6Network
Resolve = Callable[[str, int], Awaitable[Sequence[str]]]
"""``resolve(host, port)``: the addresses of a host. Raises OSError: there are none."""

_NAME = re.compile(r"(\*\.)?[a-z0-9_-]+(\.[a-z0-9_-]+)*")
LOCALHOST = "localhost"
SETTING = "set HOISTWAY_WEBHOOK_TARGETS, or webhook_targets in the settings file"
REMEDY = (
    "Name the host, *.domain, address or network in HOISTWAY_WEBHOOK_TARGETS, or as webhook_targets in the settings file, "
    "and start the controller again."
)
NO_URL = "Write a URL of http or https, without a name, a password or a fragment."


class TargetsError(HoistwayError):
    """A target in the settings cannot be read."""

    code = "settings"


async def resolved(host: str, port: int) -> Sequence[str]:
    """Return the addresses of a host, as the system has them."""
    found = await asyncio.get_running_loop().getaddrinfo(host, port, type=1)
    return [str(entry[4][0]) for entry in found]


class Targets:
    """The targets that the settings allow: ``mes.fab``, ``mes.fab:8443``, ``*.fab``, ``10.1.2.3``, ``10.0.0.0/8``.

    A name that is allowed may resolve to any address but loopback, link-local and the like: those must be named as addresses
    (or as ``localhost``). Raises TargetsError.
    """

    def __init__(self, entries: Sequence[str], resolve: Resolve = resolved) -> None:
        self._resolve = resolve
        self._names: list[tuple[str, int | None]] = []
        self._networks: list[Network] = []
        for entry in entries:
            self._add(entry.strip().lower())

    def refusal(self, url: str) -> str:
        """Return why nothing may be sent to a URL, as far as that can be said without resolving its name; empty if it may."""
        if why := _no_url(url):
            return why
        parts = urlsplit(url)
        assert parts.hostname is not None
        if not self._names and not self._networks:
            return "this server may send to nobody"
        address = _address(parts.hostname)
        if address is not None:
            return "" if self._listed(address) else f"{parts.hostname} is not among the targets that are allowed"
        return "" if self._named(parts.hostname, parts.port or _usual(parts.scheme)) else (
            f"{parts.hostname} is not among the targets that are allowed"
        )  # fmt: skip

    def remedy(self, url: str) -> str:
        """Return what would help where a URL is refused: another URL, or another setting."""
        return NO_URL if _no_url(url) else REMEDY

    async def address(self, url: str) -> str:
        """Return the address to connect to. Raises OSError: there is none that is allowed."""
        if why := self.refusal(url):
            raise OSError(f"{why}; {SETTING}" if self.remedy(url) is REMEDY else why)
        parts = urlsplit(url)
        assert parts.hostname is not None
        literal = _address(parts.hostname)
        if literal is not None:
            return str(literal)
        found = await self._resolve(parts.hostname, parts.port or _usual(parts.scheme))
        for text in found:
            address = _address(text)
            if address is not None and self._allowed(parts.hostname, address):
                return str(address)
        raise OSError(f"{parts.hostname} leads to {', '.join(found) or 'no address'}, which is not allowed; {SETTING}")

    def _allowed(self, host: str, address: Address) -> bool:
        if self._listed(address):
            return True
        if address.is_loopback:
            return host == LOCALHOST
        return not (address.is_link_local or address.is_multicast or address.is_unspecified or address.is_reserved)

    def _listed(self, address: Address) -> bool:
        return any(address in network for network in self._networks)

    def _named(self, host: str, port: int) -> bool:
        return any(
            wanted in (None, port) and (host == name or (name.startswith("*.") and host.endswith(name[1:])))
            for name, wanted in self._names
        )

    def _add(self, entry: str) -> None:
        try:
            self._networks.append(ipaddress.ip_network(entry.strip("[]")))
            return
        except ValueError:
            pass
        name, _, port = entry.partition(":")
        if not _NAME.fullmatch(name) or (port and not (port.isdigit() and 0 < int(port) < 65536)):
            remedy = "Write such as mes.fab, mes.fab:8443, *.fab, 10.1.2.3 or 10.0.0.0/8."
            raise TargetsError(f"webhook_targets: {entry!r} is no host, address or network", remedy=remedy)
        self._names.append((name, int(port) if port else None))


def _no_url(url: str) -> str:
    """Return why a URL is none that is sent to, whatever the settings allow; empty: it is one."""
    try:
        parts = urlsplit(url)
        _ = parts.port
    except ValueError as wrong:
        return f"it is no URL: {wrong}"
    if parts.scheme not in {"http", "https"} or not parts.hostname:
        return "it is no URL of http or https"
    if parts.username is not None or parts.password is not None:
        return "a URL with a name or password in it would stand in logs"
    return "a fragment is never sent" if parts.fragment else ""


def _usual(scheme: str) -> int:
    return 443 if scheme == "https" else 80


def _address(text: str) -> Address | None:
    try:
        address = ipaddress.ip_address(text.strip("[]").partition("%")[0])
    except ValueError:
        return None
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return mapped or address
