"""Our end of an ENIG link: commands out, what the devices on it say in (PROTOCOLS 3, 6.1, 6.2; COMMANDS 1, 3)."""

from app.protocols.enig.session.session import LinkQuality, LinkSession
from app.protocols.enig.session.timing import Timing

__all__ = ["LinkQuality", "LinkSession", "Timing"]
