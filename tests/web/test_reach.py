"""What the API offers is on the page, or it is said here why not; and the page asks for nothing that there is not."""

import re
from dataclasses import fields, is_dataclass
from pathlib import Path

from app.api.policy import ROUTES
from app.domain import alarms, closures, device_requests, drive_requests, requests, teaching_requests, walks, webhooks
from app.domain.access import Scope
from app.fleet.desk import UNSAID

SOURCES = Path(__file__).parents[2] / "web" / "src"
TEXT = "\n".join(file.read_text(encoding="utf-8") for file in sorted(SOURCES.rglob("*.ts*")))
NEEDS = set(re.findall(r'"((?:GET|POST|PUT|PATCH|DELETE) /[^"]+)"', TEXT))

ELSEWHERE: dict[str, str] = {
    "DELETE /session": "logging out is everybody's",
    "POST /session/renew": "the page does it by itself",
    "POST /drives/{drive}/jog/{jog}": "the held button of POST /drives/{drive}/jog",
    "DELETE /drives/{drive}/jog/{jog}": "the same, let go",
    "DELETE /drives/{drive}/watches/{watch}": "the button of PUT, pressed again",
    "POST /drives/{drive}/parameters/{number}/read": "POST /drives/{drive}/read reads what is shown",
    "PUT /stations/{station}": "PATCH writes what a person knows, and leaves the rest",
}
"""A change that has no button of its own -> why."""


def test_every_button_names_a_row_of_the_policy() -> None:
    assert NEEDS - set(ROUTES) == set()


def test_every_change_that_can_be_asked_for_has_its_button_or_a_reason_why_not() -> None:
    reading = {Scope.READ, Scope.READ_AUDIT, Scope.PUBLIC, Scope.METRICS}
    changes = {row for row, scope in ROUTES.items() if not row.startswith(("GET ", "LIVE ")) and scope not in reading}
    missing = sorted(changes - NEEDS)
    assert missing == sorted(ELSEWHERE), "give it a button with needs, or say in ELSEWHERE why it has none"


ASKED = (requests, device_requests, drive_requests, teaching_requests, closures, walks, webhooks, alarms)
KEPT = {"Walk", "Webhook", "Alarm", "Closure"}
"""What is kept, not asked."""


def test_every_part_of_a_request_that_the_audit_says_has_its_word_on_the_page() -> None:
    known = set(re.findall(r'^  (\w+): "', (SOURCES / "details.ts").read_text(encoding="utf-8"), re.MULTILINE))
    missing: dict[str, set[str]] = {}
    theirs = (cls for module in ASKED for cls in vars(module).values() if isinstance(cls, type))
    for cls in (cls for cls in theirs if cls.__module__ in {module.__name__ for module in ASKED}):
        parts = {one.name for one in fields(cls)} if is_dataclass(cls) else set()
        if "actor" in parts and cls.__name__ not in KEPT and (lacking := parts - known - UNSAID):
            missing[cls.__name__] = lacking
    assert "vehicle" in known
    assert missing == {}
