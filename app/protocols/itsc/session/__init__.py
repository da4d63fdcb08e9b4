"""Our end of an iTSC line: commands out, what the vehicle says in (PROTOCOLS 1.2, 6.1, 6.2; COMMANDS 1 to 3)."""

from app.protocols.itsc.session.link import LinkQuality
from app.protocols.itsc.session.session import Session, Told
from app.protocols.itsc.session.timing import Timing

__all__ = ["LinkQuality", "Session", "Timing", "Told"]
