"""The bodies of a simulated vehicle's answers and events, in its dialect (PROTOCOLS 1.6, 1.7)."""

from collections.abc import Callable

from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import Code, Raw, Resp1, Resp2, Teach
from app.protocols.itsc.simulator.options import Options
from app.protocols.itsc.simulator.state import State
from app.protocols.itsc.simulator.teaching import TAUGHT_AXIS


class Reporter:
    """Puts the state into words. ``past`` gives mm from the last barcode."""

    def __init__(self, dialect: Dialect, options: Options, past: Callable[[], float]) -> None:
        self._dialect = dialect
        self._options = options
        self._past = past

    def resp1(self, state: State, result: int) -> Resp1:
        """Return RESP1: RESULT 0 completed normally, 1 abnormally."""
        return Resp1(result, state.status2(self._options), self._barcode(state), state.seq, self._dist())

    def resp2(self, state: State) -> Resp2:
        """Return RESP2, for STATUS as answer and as event."""
        status1, status2 = state.status1(self._options), state.status2(self._options)
        return Resp2(status1, status2, self._barcode(state), state.seq, self._dist())

    def resp3(self) -> Raw:
        """Return the undefined answer to DISTANCE (I31): mm from the barcode in DATA1. Our choice."""
        return Raw(self._millimetres().to_bytes(4, self._dialect.byte_order) + bytes(12))

    def teach(self, state: State, kind: Code) -> Teach:
        """Return an axis' position with the barcode."""
        return Teach(state.pulses[TAUGHT_AXIS[kind]], self._barcode(state))

    def _barcode(self, state: State) -> int | str:
        """Return the barcode as the dialect writes it: 0 or nothing as long as none is recognised."""
        if self._dialect.barcode_format == "ascii":
            return state.barcode or ""
        return int(state.barcode) if state.barcode is not None else 0

    def _millimetres(self) -> int:
        """Whole mm from the last barcode, at most 65535 (I43)."""
        return min(0xFFFF, int(self._past()))

    def _dist(self) -> int | None:
        return self._millimetres() if self._dialect.has_dist else None
