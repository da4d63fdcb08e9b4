"""What of the web server's log is written."""

import logging
import sys

from app.runtime.telemetry import CALLERS_FAULT, NO_FAULT, QUIET, Sparing


def line(text: str, at: float, *, failed: bool = False) -> logging.LogRecord:
    record = logging.LogRecord("uvicorn.error", logging.WARNING, __file__, 1, text, None, None)
    record.created = at
    if failed:
        try:
            raise ValueError
        except ValueError:
            record.exc_info = sys.exc_info()
    return record


def test_the_same_line_about_callers_is_written_once_a_minute() -> None:
    sparing = Sparing()
    written = [at for at in range(200) if sparing.filter(line("Invalid HTTP request received.", float(at)))]
    assert written == [0, int(QUIET), 2 * int(QUIET), 3 * int(QUIET)]
    assert sparing.filter(line("something else", 1.0))


def test_every_defect_is_written_with_its_traceback() -> None:
    sparing = Sparing()
    for _ in range(3):
        record = line("Exception in ASGI application", 0.0, failed=True)
        assert sparing.filter(record)
        assert record.exc_info


def test_what_a_caller_did_wrong_is_no_defect() -> None:
    sparing = Sparing()
    for text in CALLERS_FAULT:
        record = line(text, 0.0, failed=True)
        assert sparing.filter(record)
        assert record.exc_info is None
        assert not sparing.filter(line(text, 1.0, failed=True))
    assert not any(sparing.filter(line(text, 0.0)) for text in NO_FAULT)


def test_many_different_lines_are_not_kept() -> None:
    sparing = Sparing()
    for number in range(1000):
        assert sparing.filter(line(str(number), 0.0))
    assert len(sparing._told) <= 100
