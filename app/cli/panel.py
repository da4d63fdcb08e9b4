"""What is set at the panel of a simulated drive: its mode, or an error (``hoistway sim --panel AX1=jog``)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.cli.plainly import CannotStart

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from app.domain.drive import DriveId
    from app.domain.units import Seconds
    from app.protocols.hi.simulator import SimulatedDrive

_ERROR = "error"


def set_panels(wishes: Iterable[str], drives: Mapping[DriveId, SimulatedDrive], now: Seconds) -> None:
    """Set each drive as wished: ``DRIVE=monitoring``, ``=jog``, ``=parameter_select``, or ``=error7``. Raises CannotStart."""
    from app.domain.drive import DriveId
    from app.protocols.hi.messages import Mode

    modes = {mode.name.lower(): mode for mode in Mode if mode is not Mode.ERROR}
    for wish in wishes:
        name, _, what = wish.partition("=")
        drive = drives.get(DriveId(name))
        if drive is None:
            raise CannotStart(
                f"there is no drive {name!r} in the plant", remedy=f"there are: {', '.join(drives) or 'none'}"
            )
        number = what.removeprefix(_ERROR)
        if what in modes:
            drive.panel_mode(modes[what], now)
        elif what.startswith(_ERROR) and number.isascii() and number.isdigit() and 1 <= int(number) <= 16:
            drive.fail(int(number), now)
        else:
            raise CannotStart(
                f"a panel cannot be set to {what!r}", remedy=f"write {', '.join(modes)}, error1 … error16"
            )
