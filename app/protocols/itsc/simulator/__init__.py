"""The vehicle's end of an iTSC line, written from PROTOCOLS 5.1 alone."""

from app.protocols.itsc.messages import Mode
from app.protocols.itsc.simulator.options import Options, RespTiming
from app.protocols.itsc.simulator.state import State
from app.protocols.itsc.simulator.surroundings import Places, Surroundings
from app.protocols.itsc.simulator.track import Track
from app.protocols.itsc.simulator.traveler import Place
from app.protocols.itsc.simulator.vehicle import SimulatedVehicle

__all__ = [
    "Mode",
    "Options",
    "Place",
    "Places",
    "RespTiming",
    "SimulatedVehicle",
    "State",
    "Surroundings",
    "Track",
]
