"""How often somebody may try to log in: free at first, then with pauses that double."""

from dataclasses import dataclass

ROOM = 10_000
"""Most accounts and addresses that are remembered; the one that failed longest ago goes. Our choice."""
FORGET = 3600.0
"""Seconds after the last failure until all is forgotten. Our choice."""


@dataclass(frozen=True, slots=True)
class Patience:
    """So many failures are free; then the pause doubles, from one second up to ``longest``."""

    free: int
    longest: float

    def pause(self, failures: int) -> float:
        """Return how long to wait after so many failures, seconds."""
        over = failures - self.free
        return 0.0 if over < 0 else min(self.longest, 2.0 ** min(over, 20))


OF_ACCOUNT = Patience(5, 60.0)
"""Short at its longest: whoever knows a name must not be able to keep its owner out. Our choice."""
OF_ADDRESS = Patience(20, 900.0)
"""Several people may come through one address. Our choice."""


class Throttle:
    """Counts failures by account and by address. ``now`` is any monotonic clock, seconds.

    An attempt counts as failed from the moment it begins until it is known to be good, so that many at once are no way round.
    """

    def __init__(self, account: Patience = OF_ACCOUNT, address: Patience = OF_ADDRESS) -> None:
        self._account, self._address = account, address
        self._failed: dict[tuple[str, str], tuple[int, float]] = {}

    def begin(self, account: str, address: str, now: float) -> float:
        """Begin an attempt; return 0, or how long to wait before the next one, seconds: then nothing has begun."""
        kinds = self._kinds(account, address)
        wait = max(self._due(kind, patience, now) - now for kind, patience in kinds)
        if wait > 0.0:
            return wait
        for kind, _ in kinds:
            failures, _ = self._recent(kind, now)
            self._failed.pop(kind, None)
            if len(self._failed) >= ROOM:
                self._failed.pop(next(iter(self._failed)))
            self._failed[kind] = failures + 1, now
        return 0.0

    def good(self, account: str, address: str) -> None:
        """The attempt was good: the account's failures are forgotten, and the address has one less."""
        account_kind, address_kind = (kind for kind, _ in self._kinds(account, address))
        self._failed.pop(account_kind, None)
        failures, since = self._failed.pop(address_kind, (0, 0.0))
        if failures > 1:
            self._failed[address_kind] = failures - 1, since

    def _kinds(self, account: str, address: str) -> tuple[tuple[tuple[str, str], Patience], ...]:
        return (("account", account.casefold()), self._account), (("address", address), self._address)

    def _due(self, kind: tuple[str, str], patience: Patience, now: float) -> float:
        failures, since = self._recent(kind, now)
        return since + patience.pause(failures)

    def _recent(self, kind: tuple[str, str], now: float) -> tuple[int, float]:
        failures, since = self._failed.get(kind, (0, -FORGET))
        return (0, -FORGET) if now - since >= FORGET else (failures, since)
