"""Logs: one line per happening, for a person at a terminal or as JSON for a collector."""

import logging
import sys

import structlog
from structlog.typing import FilteringBoundLogger, Processor


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
