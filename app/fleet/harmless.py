"""What a lockout and an emergency let through: it reads, or ends something; it starts nothing (our choice)."""

from app.domain.commands import Command, Direct, Plain, Simple
from app.domain.devices import AgvCharge, AgvLift, DeviceAct, DeviceCommand, LiftAction

PLAIN = frozenset({Plain.STATUS, Plain.STOP, Plain.STOP_BY_HOST})
OF_AGVS: frozenset[DeviceCommand] = frozenset({DeviceAct.MARK_STOP, AgvLift(LiftAction.STOP), AgvCharge(on=False)})


def harmless(command: Command) -> bool:
    """Whether a command may go to a vehicle that people are at."""
    match command:
        case Simple(what=what):
            return what in PLAIN
        case Direct(command=direct):
            return direct in OF_AGVS
        case _:
            return False
