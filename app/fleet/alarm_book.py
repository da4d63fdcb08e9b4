"""The alarms there are now: each begins once, is kept, and ends once; who has seen it is kept with it."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from app.domain.alarms import AcknowledgeAlarm, Alarm, AlarmKind
from app.domain.errors import Refusal
from app.domain.ids import JobId
from app.domain.requests import Accepted, Reply
from app.domain.units import Timestamp
from app.domain.view import Topic

REMEMBERED = 1000
"""So many alarms that have ended are remembered: an acknowledgement may come just then (our choice)."""

Key = tuple[AlarmKind, str, str]


class AlarmBook:
    """Alarms by what they are about. ``keep`` takes each alarm as it is now; ``utc`` gives the present moment."""

    def __init__(
        self, kept: Iterable[Alarm], next_number: int, keep: Callable[[Alarm], None], utc: Callable[[], Timestamp]
    ) -> None:
        self._keep, self._utc, self._next = keep, utc, next_number
        self.live: dict[int, Alarm] = {}
        self._by_key: dict[Key, int] = {}
        self._by_source: dict[tuple[AlarmKind, str], dict[Key, None]] = {}
        self._ended: dict[int, Alarm] = {}
        for alarm in kept:
            self._note(alarm)

    def _note(self, alarm: Alarm) -> None:
        key = (alarm.kind, alarm.source, alarm.code)
        of_source = self._by_source.setdefault(key[:2], {})
        if alarm.ended is None:
            self.live[alarm.number] = alarm
            self._by_key[key] = alarm.number
            of_source[key] = None
            return
        self.live.pop(alarm.number, None)
        self._by_key.pop(key, None)
        of_source.pop(key, None)
        if not of_source:
            del self._by_source[key[:2]]
        self._ended[alarm.number] = alarm
        if len(self._ended) > REMEMBERED:
            del self._ended[next(iter(self._ended))]

    def begin(
        self, kind: AlarmKind, source: str, code: str, cause: str, remedy: str = "", job: JobId | None = None
    ) -> None:
        """Let an alarm begin; one that is there already gets the newest cause and remedy."""
        number = self._by_key.get((kind, source, code))
        if number is None:
            alarm = Alarm(self._next, kind, source, code, cause, remedy, self._utc(), job)
            self._next += 1
        else:
            alarm = replace(self.live[number], cause=cause, remedy=remedy)
            if alarm == self.live[number]:
                return
        self._note(alarm)
        self._keep(alarm)

    def begin_only(
        self, kind: AlarmKind, source: str, code: str, cause: str, remedy: str = "", job: JobId | None = None
    ) -> None:
        """Let this be the only alarm of its kind about a machine: another one ends."""
        self.end(kind, source, "another one has begun", but=code)
        self.begin(kind, source, code, cause, remedy, job)

    def end(self, kind: AlarmKind, source: str, outcome: str, but: str | None = None) -> None:
        """Let every alarm of a kind about a machine end, but for the one with this code."""
        for _, _, code in tuple(self._by_source.get((kind, source), ())):
            if code != but:
                self.end_one(kind, source, code, outcome)

    def end_one(self, kind: AlarmKind, source: str, code: str, outcome: str) -> None:
        """Let one alarm end, if it is there."""
        number = self._by_key.get((kind, source, code))
        if number is not None:
            ended = replace(self.live[number], ended=self._utc(), outcome=outcome)
            self._note(ended)
            self._keep(ended)

    def about(self, kind: AlarmKind, source: str) -> bool:
        """Return whether there is an alarm of this kind about a machine."""
        return (kind, source) in self._by_source

    def codes(self, kind: AlarmKind, source: str) -> set[str]:
        """Return what the alarms of this kind about a machine are counted by."""
        return {code for _, _, code in self._by_source.get((kind, source), ())}

    def acknowledge(self, request: AcknowledgeAlarm) -> Reply:
        """Write down who knows of an alarm; the first one stays."""
        alarm = self.live.get(request.alarm) or self._ended.get(request.alarm) or request.known
        if alarm is None:
            return Refusal("not-found", f"there is no alarm {request.alarm}", "see GET /api/v1/alarms")
        if alarm.acknowledged_by is None:
            seen = replace(alarm, acknowledged=self._utc(), acknowledged_by=request.actor, note=request.note)
            if seen.number in self.live:
                self.live[seen.number] = seen
            else:
                self._ended[seen.number] = seen
            self._keep(seen)
        return Accepted(Topic.ALARMS, str(alarm.number))
