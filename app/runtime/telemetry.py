"""Logs: one line per happening, for a person at a terminal or as JSON for a collector."""

import logging
import sys

import structlog
from structlog.typing import FilteringBoundLogger, Processor

QUIET = 60.0
"""Seconds until the web server may say the same again of a caller. Our choice."""
CALLERS_FAULT = frozenset({"Invalid UTF-8 sequence received from client."})
"""What the web server tells with a traceback, though nothing is wrong with it."""
NO_FAULT = frozenset({"ASGI callable returned without completing handshake."})
"""What it calls an error though it is none: a WebSocket that was refused as HTTP has it (uvicorn up to 0.54)."""


class Sparing(logging.Filter):
    """Lets each line of the web server through once a minute, and every defect: hostile callers must not fill the log."""

    def __init__(self) -> None:
        super().__init__()
        self._told: dict[str, float] = {}

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether to write the line."""
        text = record.getMessage()
        if text in CALLERS_FAULT:
            record.exc_info = None
        if record.exc_info:
            return True
        if text in NO_FAULT or record.created - self._told.get(text, -QUIET) < QUIET:
            return False
        if len(self._told) >= 100:
            self._told.clear()
        self._told[text] = record.created
        return True


def set_up(*, as_json: bool | None = None, level: str = "info") -> None:
    """Send logs to standard error. ``as_json`` None: JSON unless standard error is a terminal."""
    if as_json is None:
        as_json = not sys.stderr.isatty()
    processors: list[Processor] = [
        structlog.contextvars.merge_contextvars,
        structlog.processors.add_log_level,
        structlog.processors.TimeStamper(fmt="iso", utc=True),
    ]
    if as_json:
        processors += [structlog.processors.dict_tracebacks, structlog.processors.JSONRenderer()]
    else:
        processors.append(structlog.dev.ConsoleRenderer(colors=sys.stderr.isatty()))
    number = logging.getLevelNamesMapping()[level.upper()]
    logging.basicConfig(stream=sys.stderr, level=logging.WARNING, format="%(levelname)s %(name)s: %(message)s")
    logging.getLogger("uvicorn.error").addFilter(Sparing())
    structlog.configure(
        processors=processors,
        wrapper_class=structlog.make_filtering_bound_logger(number),
        logger_factory=structlog.PrintLoggerFactory(file=sys.stderr),
        cache_logger_on_first_use=True,
    )


def logger(**bound: str) -> FilteringBoundLogger:
    """Return a logger that says ``bound`` with every line."""
    log: FilteringBoundLogger = structlog.get_logger(**bound)
    return log
