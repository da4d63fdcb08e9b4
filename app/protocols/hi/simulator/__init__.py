"""The drives' end of an HI line, written from PROTOCOLS 5.2 alone."""

from app.protocols.hi.simulator.drive import SimulatedDrive
from app.protocols.hi.simulator.line import SimulatedLine
from app.protocols.hi.simulator.options import Mischief, Options
from app.protocols.hi.simulator.state import State

__all__ = ["Mischief", "Options", "SimulatedDrive", "SimulatedLine", "State"]
