"""The devices' end of an ENIG link, written from PROTOCOLS 5.3 alone."""

from app.protocols.enig.simulator.agv import SimulatedAgv
from app.protocols.enig.simulator.buffer import SimulatedBuffer
from app.protocols.enig.simulator.door import SimulatedDoor
from app.protocols.enig.simulator.hall import Hall
from app.protocols.enig.simulator.link import SimulatedLink
from app.protocols.enig.simulator.options import AgvOptions, BufferOptions, DoorOptions
from app.protocols.enig.simulator.tape import Tape, both_ways

__all__ = [
    "AgvOptions",
    "BufferOptions",
    "DoorOptions",
    "Hall",
    "SimulatedAgv",
    "SimulatedBuffer",
    "SimulatedDoor",
    "SimulatedLink",
    "Tape",
    "both_ways",
]
