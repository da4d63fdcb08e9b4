"""Our end of a drive line: the one master that asks, one drive at a time (PROTOCOLS 2.3, 6.1, 6.2; COMMANDS section 1)."""

from app.protocols.hi.session.drives import DriveView
from app.protocols.hi.session.line import Figures
from app.protocols.hi.session.session import LineSession
from app.protocols.hi.session.timing import Timing

__all__ = ["DriveView", "Figures", "LineSession", "Timing"]
