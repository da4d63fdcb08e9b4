"""A maintenance lockout of a vehicle or a device (DOMAIN section 7)."""

from dataclasses import dataclass, replace

from app.domain.access import shown_name
from app.domain.ids import Actor
from app.domain.units import Timestamp


@dataclass(frozen=True, slots=True)
class Lockout:
    """People are at the machine: no remote command, no grant (DOMAIN section 7)."""

    owner: Actor
    reason: str
    since: Timestamp
    releases: tuple[Actor, ...] = ()

    def __str__(self) -> str:
        """Return it as the end of a sentence about the machine."""
        return f"locked out by {self.owner}: {self.reason}"

    def wished_away_by(self, actor: Actor) -> "Lockout":
        """Return it with one more who wishes to lift it."""
        return replace(self, releases=tuple(dict.fromkeys((*self.releases, actor))))

    def lifted_by(self, actor: Actor) -> bool:
        """Whether it goes now: its owner alone lifts it, or two others together, who have each shown who they are."""
        return actor == self.owner or len({shown_name(other) for other in self.releases}) >= 2
