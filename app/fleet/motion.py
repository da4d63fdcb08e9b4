"""Motion: from an errand to a route, to claims, to MOVE and XMOVE, and the release of what lies behind.

A vehicle moves only on what it holds. MOVE goes to the end of what is held; before the vehicle must brake for that end,
XMOVE goes on from it; where that comes too late, the vehicle stops by itself and a fresh MOVE follows (PROTOCOLS 6.2).
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, pairwise
from math import inf, sqrt

from app.domain.commands import Move, Xmove
from app.domain.errors import NoRoute
from app.domain.events import Answered
from app.domain.ids import StationId, VehicleId
from app.domain.job import Job
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.units import Barcode, Millimetres, Seconds
from app.domain.vehicle import Oper
from app.fleet.books import SYSTEM, Books
from app.fleet.closed import Reason
from app.fleet.cover import covered, maybe_covered, next_tag
from app.fleet.detours import Detours
from app.fleet.halting import halt
from app.fleet.horizon import horizon
from app.fleet.passages import Passages
from app.fleet.vehicle import Amendment, Drive, Errand, Purpose, Stage, VehicleNow
from app.planning.blocking import Blocked, BlockReason
from app.planning.kinematics import braking_distance, driving_time, edge_speed, elements, time_to_braking

LAST_SEQ = 60_000
"""A path that has come this far is not extended any more; a fresh MOVE begins at SEQ 0 (PROTOCOLS I48)."""

HEARING = Seconds(0.05)
"""From the decision to an XMOVE to the vehicle's having it: our commit and the link. Our choice, as in the fast plant."""


class OffPath(Exception):
    """The vehicle reports a place that it cannot have reached on what it holds. The message is one sentence."""


class Motion:
    """Moves vehicles on their errands. Decides nothing about jobs."""

    def __init__(self, books: Books, passages: Passages) -> None:
        self._books = books
        self.passages = passages
        self.detours = Detours(books)

    # -- where it is --------------------------------------------------------------------------------------------------

    def place(self, vehicle: VehicleNow, barcode: Barcode) -> tuple[Barcode, ...]:
        """The vehicle stands at ``barcode``, by its own word: it holds what it covers there, and nothing else.

        Returns the barcodes that another vehicle holds too.
        """
        books = self._books
        books.closed.shut_only(Reason(vehicle.id, ""))  # what it stands on is closed to others, not to its own way on
        before = books.traffic.held(vehicle.id)
        vehicle.toward = next_tag(self._books.track, vehicle, barcode)
        vehicle.trail = covered(self._books, vehicle, barcode)
        beyond = tuple(b for b in books.track.successors(barcode) if b in before and b not in vehicle.trail)
        vehicle.beyond = beyond or (vehicle.beyond if vehicle.barcode == barcode else ())
        if not vehicle.way or vehicle.way[-1] != barcode:
            vehicle.way = [barcode]
        if vehicle.barcode != barcode:
            vehicle.barcode, vehicle.stopped = barcode, None
        vehicle.ahead, vehicle.rest = [], []
        held = (*reversed(vehicle.trail), *((vehicle.toward,) if vehicle.toward else ()))
        books.traffic.release(vehicle.id, [b for b in before if b not in held])
        unsure = frozenset() if len(vehicle.way) > 1 else maybe_covered(books, vehicle, barcode)
        clashes = books.traffic.hold(vehicle.id, held, unsure)
        self._wake_waiters(before)
        self._set_out_anew(vehicle)
        books.save_vehicle(vehicle, barcode=barcode, held=held)
        return tuple(dict.fromkeys(at for at, _ in clashes))

    def _set_out_anew(self, vehicle: VehicleNow) -> None:
        """The way to the errand's goal begins somewhere else now; an errand of a job is found again from the job."""
        errand, vehicle.errand = vehicle.errand, None
        if errand and errand.purpose is Purpose.PERSON:
            try:
                self.send(vehicle, errand)
            except NoRoute:
                self._books.touch(vehicle)

    def report(self, vehicle: VehicleNow, barcode: Barcode, seq: int) -> None:
        """The vehicle has read a barcode: it goes on along what it holds, and what it has left is free.

        Raises OffPath: the barcode is neither where it was nor ahead on its path, or not the one that its path has at
        this SEQ (misread, or another path).
        """
        if barcode in vehicle.trail and barcode not in vehicle.ahead[:1]:
            return
        if barcode not in vehicle.ahead:
            raise OffPath(f"{vehicle.id} reports barcode {barcode}, which is not on the track it holds")
        numbered = self._numbered(vehicle, seq)
        if numbered and barcode not in numbered:
            named = " or ".join(sorted(numbered))
            raise OffPath(f"{vehicle.id} reports barcode {barcode} at SEQ {seq}, where its path has {named}")
        count = vehicle.ahead.index(barcode) + 1
        passed = [b for b in (vehicle.barcode, *vehicle.ahead[:count]) if b is not None]
        gone = self._books.track.distance(passed)
        if vehicle.drive is not None:
            vehicle.drive.driven, vehicle.drive.read = Millimetres(vehicle.drive.driven + gone), self._books.now
        trail = {b: Millimetres(d + gone) for b, d in vehicle.trail.items()}
        for start, end in pairwise(passed):
            gone = Millimetres(gone - self._books.track.edge(start, end).length)
            trail[end] = gone
        length = vehicle.spec.length
        vehicle.trail = dict(sorted(((b, d) for b, d in trail.items() if d <= length), key=lambda item: item[1]))
        vehicle.barcode, vehicle.stopped, vehicle.beyond, vehicle.toward = barcode, None, (), None
        del vehicle.ahead[:count]
        vehicle.way += passed[1:]
        while len(vehicle.way) > 2 and vehicle.way[1] not in vehicle.trail:
            del vehicle.way[0]
        held = self._books.traffic.held(vehicle.id) if vehicle.is_agv else tuple(trail)
        left = [b for b in held if b not in vehicle.trail and b not in vehicle.ahead]
        self._books.traffic.release(vehicle.id, left)
        self._wake_waiters(left)

    def _numbered(self, vehicle: VehicleNow, seq: int) -> set[Barcode]:
        """Return the barcodes that the open MOVE, amended or not, has at this SEQ; 0 may be a reset counter's."""
        drive = vehicle.drive
        if drive is None or seq == 0:
            return set()
        amended = drive.amendment.path if drive.amendment else ()
        return {element.barcode for element in (*drive.path, *amended) if element.seq == seq}

    def shrink_ahead(self, vehicle: VehicleNow) -> None:
        """Give back what is granted ahead of a vehicle that has no MOVE open and is known to stand where it says."""
        if vehicle.drive is None and vehicle.ahead and vehicle.stage is Stage.READY:
            freed, vehicle.ahead = vehicle.ahead, []
            self._books.traffic.release(vehicle.id, [b for b in freed if b not in vehicle.trail])
            self._wake_waiters(freed)

    def vacate(self, vehicle: VehicleNow) -> None:
        """The vehicle is not on the track: all it held is free."""
        freed = self._books.traffic.held(vehicle.id)
        self._books.traffic.clear(vehicle.id)
        vehicle.trail, vehicle.ahead, vehicle.rest, vehicle.barcode = {}, [], [], None
        vehicle.way, vehicle.beyond = [], ()
        self._wake_waiters(freed)

    def _wake_waiters(self, barcodes: list[Barcode] | tuple[Barcode, ...]) -> None:
        for waiter in self._books.traffic.waiters(barcodes):
            self._books.wake(waiter)

    # -- where it goes ------------------------------------------------------------------------------------------------

    def send(self, vehicle: VehicleNow, errand: Errand, way: tuple[Barcode, ...] | None = None) -> None:
        """Give the vehicle an errand, by the way given (from where it is) or the quickest.

        Raises NoRoute: no way leads there from the end of what it holds.
        """
        if vehicle.drive is None:
            self.shrink_ahead(vehicle)
        start = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        if start is None:
            raise NoRoute(f"the place of {vehicle.id} is not known")
        rest = self._way(vehicle, start, errand.goal) if way is None else list(way[1:])
        vehicle.errand, vehicle.rest = errand, rest
        self._books.touch(vehicle)
        self._books.wake(vehicle.id)

    def _way(self, vehicle: VehicleNow, start: Barcode, goal: Barcode) -> list[Barcode]:
        """Return the barcodes from ``start``, left out, to the goal. Raises NoRoute.

        An AGV that was stopped between two tags comes to the second one first: it would turn, or not, as it likes.
        """
        rest = self._books.router.route(start, goal)[1:]
        via = vehicle.toward if start == vehicle.barcode and not vehicle.ahead else None
        if via is None or rest[:1] == [via]:
            return rest
        return self._books.router.route(via, goal)

    def lead(self, vehicle: VehicleNow, rest: Sequence[Barcode]) -> None:
        """Let a vehicle go on to its errand's goal by this way from the end of what it holds."""
        vehicle.rest = list(rest)
        self._books.touch(vehicle)
        self._wake_waiters(())
        self._books.wake(vehicle.id)

    def drop(self, vehicle: VehicleNow) -> None:
        """Forget the errand: the vehicle runs to the end of what it was told, and stays there."""
        vehicle.errand, vehicle.rest, vehicle.waiting = None, [], ""
        self._books.traffic.forget(vehicle.id)
        self.shrink_ahead(vehicle)
        self._wake_waiters(())
        self._books.touch(vehicle)

    def arrived(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle stands where its errand leads, stopped as the errand wants it."""
        errand = vehicle.errand
        if errand is None or vehicle.drive is not None or vehicle.barcode != errand.goal or vehicle.rest:
            return False
        return vehicle.in_position and (errand.action is StopAction.STOP or vehicle.stopped is errand.action)

    def may_drive(self, vehicle: VehicleNow) -> bool:
        """Whether grants may be given to this vehicle at all."""
        books = self._books
        if not vehicle.fit or vehicle.barcode is None or books.stilled(vehicle):
            return False
        return not books.roll_call.misses(vehicle.barcode)

    def missing(self, vehicle: VehicleNow) -> tuple[VehicleId, ...]:
        """Return the vehicles that the roll-call still misses in this vehicle's area (COMMANDS section 3.6)."""
        return () if vehicle.barcode is None else self._books.roll_call.missing(vehicle.barcode)

    def advance(self, vehicle: VehicleNow) -> Blocked | None:
        """Claim what is wanted next and tell the vehicle. Returns what stands against it, if anything does."""
        if vehicle.errand is None or vehicle.handling is not None or not self.may_drive(vehicle):
            return None
        if vehicle.drive is None:
            return None if self.arrived(vehicle) else self._start(vehicle)
        return self._extend(vehicle, vehicle.drive)

    def recall(self, vehicle: VehicleNow, why: str) -> None:
        """Take back what a vehicle is granted ahead: one that stands plans anew, one that drives is stopped first.

        One that is being asked where it is keeps what it has until it is settled.
        """
        drive = vehicle.drive
        if drive is None:
            errand, before = vehicle.errand, len(vehicle.ahead)
            self.shrink_ahead(vehicle)
            if errand and len(vehicle.ahead) < before:
                self._set_out_anew_on(vehicle, errand)
        elif not drive.recalled:
            halt(self._books, vehicle, SYSTEM, why)

    def _set_out_anew_on(self, vehicle: VehicleNow, errand: Errand) -> None:
        try:
            self.send(vehicle, errand)
        except NoRoute:
            self.drop(vehicle)

    def _claim(self, vehicle: VehicleNow, horizon: Millimetres) -> Blocked | None:
        """Claim along the rest of the way so that about ``horizon`` lies ahead; move what is granted to ``ahead``."""
        track = self._books.track
        start = vehicle.barcode
        if start is None:
            return None
        held = track.distance([start, *vehicle.ahead])
        room = vehicle.spec.max_count - 1 - len(vehicle.ahead)
        last = vehicle.ahead[-1] if vehicle.ahead else start
        wanted: list[Barcode] = []
        shut: Blocked | None = None
        for start_of_edge, barcode in pairwise(chain((last,), vehicle.rest)):
            enough = held >= horizon and self._books.traffic.may_end(last if not wanted else wanted[-1])
            if enough or len(wanted) >= room:
                break
            if closed := self._books.closures.edge(start_of_edge, barcode):
                shut = Blocked(barcode, None, BlockReason.CLOSED, note=closed)
                break
            if (door := self.passages.barred(start_of_edge, barcode)) is not None:
                shut = Blocked(barcode, None, BlockReason.DOOR, note=self.passages.wait_for(door))
                break
            wanted.append(barcode)
            held = Millimetres(held + track.edge(start_of_edge, barcode).length)
        if not wanted:
            if shut:
                self._books.traffic.forget(vehicle.id)
            return shut
        count, rest = len(wanted), vehicle.rest
        grant = self._books.traffic.claim(
            vehicle.id,
            wanted,
            count == len(rest),
            beyond=rest,
            begun=count,
            now=self._books.now,
            cut_short=count >= room,
        )
        self._wake_waiters(())
        vehicle.ahead += grant.granted
        del vehicle.rest[: len(grant.granted)]
        return grant.blocked if shut is None or (grant.blocked and grant.blocked.by) else shut

    def _start(self, vehicle: VehicleNow) -> Blocked | None:
        """The vehicle stands: MOVE as far as it may."""
        if next(self.passages.shut_ahead(vehicle), None) is not None:
            self.recall(vehicle, "a door on its way is not open any more")
        errand, here = vehicle.errand, vehicle.barcode
        if errand is None or here is None:
            return None
        _, high = horizon(self._books, vehicle)
        if not vehicle.ahead and not vehicle.rest:
            vehicle.rest = self._round(vehicle, here)
        blocked = self._claim(vehicle, high)
        if not vehicle.ahead and vehicle.rest and self.detours.over_free_track(vehicle, errand.goal):
            blocked = self._claim(vehicle, high)
        if not vehicle.ahead and blocked and self.detours.as_committed(vehicle, errand.goal):
            blocked = self._claim(vehicle, high)
        if not vehicle.ahead and vehicle.rest:
            return blocked
        path = [here, *vehicle.ahead]
        action = StopAction.STOP if vehicle.rest else errand.action
        planned = driving_time(self._books.track, path, vehicle.spec)
        move_path = elements(self._books.track, path, action, vehicle.spec)
        job = self._books.job_of(vehicle)
        foup, source, destination = self._display(job)
        intent = self._books.open_intent(
            vehicle,
            "move",
            Move(move_path, planned, foup, source, destination),
            job.actor if job else SYSTEM,
            job=job.id if job else None,
            path=tuple(path),
            body={"action": action.name, "goal": errand.goal, "purpose": errand.purpose.value},
        )
        vehicle.drive = Drive(intent.cmd_id, move_path, intent)
        vehicle.waiting = ""
        return blocked

    def _round(self, vehicle: VehicleNow, here: Barcode) -> list[Barcode]:
        """Return the way round to the barcode that a hoist read last, where it cannot be told to stop: it is past it.

        It was broken off on its way to a next barcode, or refused to stop at this one. Empty: it is where it says, as far
        as is known, or there is no way round. Where it may be on its way to several, each is tried in its turn.
        """
        if vehicle.is_agv or not vehicle.missed or not vehicle.beyond:
            return []
        router = self._books.router
        ways = sorted((router.time(via, here), via) for via in vehicle.beyond)
        open_ways = [via for seconds, via in ways if seconds < inf]
        if not open_ways:
            return []
        return list(router.route(open_ways[(vehicle.missed - 1) % len(open_ways)], here))

    def _display(self, job: Job | None) -> tuple[str, str, str]:
        """Return FOUP ID, SOURCE and DESTINATION for the vehicle's display."""
        if job is None:
            return "", "", ""
        names = [
            self._books.specs[StationId(place)].display or place if place in self._books.specs else place
            for place in (job.source, job.destination)
        ]
        return job.carrier or "", names[0], names[1]

    def _extend(self, vehicle: VehicleNow, drive: Drive) -> Blocked | None:
        """The vehicle moves: XMOVE from its STOP element on, while it need not brake for that yet."""
        errand, here = vehicle.errand, vehicle.barcode
        if errand is None or here is None or drive.amendment or drive.stopping or drive.acknowledged is None:
            return None
        track = self._books.track
        ending = [here, *vehicle.ahead]
        left = track.distance(ending)
        low, high = horizon(self._books, vehicle)
        if drive.end.barcode != ending[-1] or left > low or not vehicle.rest or drive.end.seq > LAST_SEQ:
            return None
        blocked = self._claim(vehicle, high)
        added = vehicle.ahead[len(ending) - 1 :]
        if not added or self._brakes(vehicle, drive, ending):
            return blocked
        action = StopAction.STOP if vehicle.rest else errand.action
        path = elements(track, [drive.end.barcode, *added], action, vehicle.spec, drive.end.seq)
        planned = driving_time(track, [here, *vehicle.ahead], vehicle.spec)
        intent = self._books.open_intent(
            vehicle,
            "xmove",
            Xmove(path, planned, drive.cmd_id),
            drive.intent.actor,
            job=drive.intent.job,
            path=tuple(e.barcode for e in path),
            body={"first_seq": path[0].seq, "action": action.name},
            amends=drive.cmd_id,
        )
        drive.amendment = Amendment(intent.cmd_id, path, intent)
        vehicle.waiting = ""
        return blocked

    def _brakes(self, vehicle: VehicleNow, drive: Drive, ending: Sequence[Barcode]) -> bool:
        """Whether the vehicle may brake for the end of this path, from the barcode read last, before an XMOVE reaches it.

        It may have accelerated all the way since it set out. However long ago it read that barcode, it is not past the next.
        """
        spec, track, since = vehicle.spec, self._books.track, drive.read or drive.acknowledged
        if since is None or len(ending) < 2:
            return True
        first, left = track.edge(*ending[:2]).length, track.distance(ending)
        limits = [edge_speed(track.edge(start, end), spec) for start, end in pairwise(ending)]
        speed = min(limits[0], sqrt(2 * spec.acceleration * drive.driven))
        if self._books.now + HEARING < since + time_to_braking(speed, left, max(limits), spec):
            return False
        at_next = min(limits[0], sqrt(2 * spec.acceleration * (drive.driven + first)))
        return left - first < braking_distance(at_next, spec)

    # -- what became of it --------------------------------------------------------------------------------------------

    def amended(self, vehicle: VehicleNow, drive: Drive, amendment: Amendment) -> None:
        """The XMOVE was accepted: its path is the MOVE's path now."""
        books = self._books
        drive.amendment = None
        kept = tuple(e for e in drive.path if e.seq < amendment.path[0].seq)
        drive.path = kept + amendment.path
        books.close_intent(vehicle, amendment.cmd_id, IntentState.DONE, "accepted")
        extended = replace(drive.intent, path=drive.intent.path + amendment.intent.path[1:])
        drive.intent = books.keep_intent(vehicle, extended)
        books.wake(vehicle.id)

    def not_amended(self, vehicle: VehicleNow, drive: Drive, state: IntentState, outcome: str) -> None:
        """The XMOVE was refused or got no answer: the vehicle runs to its old end (or, unanswered, to the new one)."""
        amendment = drive.amendment
        if amendment is None:
            return
        drive.stopping = True
        if state is not IntentState.UNKNOWN:
            drive.amendment = None
        self._books.close_intent(vehicle, amendment.cmd_id, state, outcome)

    def finish(self, vehicle: VehicleNow, state: IntentState, outcome: str) -> None:
        """The MOVE is over, and the vehicle stands where it last said."""
        drive = vehicle.drive
        if drive is None:
            return
        if drive.amendment:
            end = drive.amendment.path[-1].barcode
            taken = vehicle.barcode == end
            known = IntentState.SETTLED_DONE if taken else IntentState.SETTLED_NOT_DONE
            self._books.close_intent(vehicle, drive.amendment.cmd_id, known, "by the place where the vehicle stands")
        self._books.close_intent(vehicle, drive.cmd_id, state, outcome)
        vehicle.drive = None
        done = state in {IntentState.DONE, IntentState.SETTLED_DONE} and vehicle.barcode == drive.end.barcode
        vehicle.stopped = drive.end.action if done else None
        vehicle.beyond = () if done else vehicle.beyond or self._perhaps_left_for(vehicle)
        if vehicle.errand is None:
            self.shrink_ahead(vehicle)
        self._books.save_vehicle(vehicle, barcode=vehicle.barcode, held=(*reversed(vehicle.trail), *vehicle.ahead))
        self._books.wake(vehicle.id)

    def _perhaps_left_for(self, vehicle: VehicleNow) -> tuple[Barcode, ...]:
        """Return where a vehicle may be on its way to whose MOVE came to nothing; one to its own place does not say."""
        if vehicle.ahead or vehicle.barcode is None or vehicle.is_agv:
            return tuple(vehicle.ahead[:1])
        return tuple(self._books.track.successors(vehicle.barcode))

    def answer(self, vehicle: VehicleNow, drive: Drive, answer: Answered) -> bool:
        """RESP1 of the MOVE. Returns whether the MOVE is over; False: it was answered on acceptance, and runs."""
        if not answer.ok:
            self.finish(vehicle, IntentState.FAILED, answer.reason or "RESULT 1")
            return True
        ends = {drive.end.barcode}
        if drive.amendment:
            ends.add(drive.amendment.path[-1].barcode)
        there = answer.barcode in ends and vehicle.barcode == answer.barcode
        if not there or answer.condition.oper is not Oper.IDLE:
            drive.answered = True
            return False
        self.finish(vehicle, IntentState.DONE, vehicle.done_by)
        return True
