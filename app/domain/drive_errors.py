"""What the errors of a drive mean and what helps (PROTOCOLS 2.4, FF in mode 4).

The specification gives the short names alone; the sentences are our reading of them.
"""

_RESET = "then press Stop/Reset"

ERRORS: dict[int, tuple[str, str]] = {
    1: ("over-current, second level", f"look for a short circuit in motor and cable, {_RESET}"),
    2: ("over-current", f"look for a jammed axis, or lengthen the acceleration, {_RESET}"),
    3: ("overheated", f"let it cool, see to its fan and its load, {_RESET}"),
    4: ("over-voltage", f"lengthen the deceleration, or see to the brake resistor and the mains, {_RESET}"),
    5: ("under-voltage", f"see to the mains and its fuses, {_RESET}"),
    6: ("braking transistor", f"see to the brake resistor, lengthen the deceleration, {_RESET}"),
    7: ("overload", f"free the axis, or lessen its load, {_RESET}"),
    8: ("overload, second level", f"free the axis, let the motor cool, {_RESET}"),
    9: ("CB0: look it up in the drive's manual", f"remove its cause, {_RESET}"),
    10: ("CB1: look it up in the drive's manual", f"remove its cause, {_RESET}"),
    11: ("CB2: look it up in the drive's manual", f"remove its cause, {_RESET}"),
    12: ("communication error", f"see to the cable and the drive's id and speed of transmission, {_RESET}"),
    13: ("mark sensor", f"clean and align the mark sensor, {_RESET}"),
    14: ("home search failed", f"see to the home sensor and the way to it, {_RESET} and search home again"),
    15: ("SE: look it up in the drive's manual", f"remove its cause, {_RESET}"),
    16: ("external error input", f"remove what sets the external input, {_RESET}"),
}
"""Error number -> what it means, what helps."""


def explained(code: int) -> tuple[str, str]:
    """Return meaning and remedy of an error."""
    return ERRORS.get(code, ("not in the specification", f"look it up in the drive's manual, {_RESET}"))
