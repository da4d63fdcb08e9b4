"""Other ways for vehicles under way, from the end of what they hold: round what has closed, and where another way has become
quicker (TRAFFIC sections 4 and 5)."""

from collections.abc import Sequence

from app.domain.errors import NoRoute
from app.domain.ids import VehicleId
from app.domain.units import Barcode, Seconds
from app.fleet.books import Books
from app.fleet.motion import Motion
from app.fleet.vehicle import Purpose, VehicleNow

LEAST_GAIN = Seconds(10.0)
LEAST_SHARE = 0.2
"""Another way is taken if it saves so many seconds at least, and so much of what is left of the present one (our choice)."""
AGAIN_AFTER = Seconds(30.0)
"""A vehicle takes a quicker way at most so often: then its last one counts for something (our choice)."""
MOST_QUICKER = 20
"""So many vehicles at most take quicker ways by the same weights: all at once, they would only move the jam (our choice)."""
LOOK_AGAIN = Seconds(5.0)
"""While anything is closed, all are looked at so often: a way may have been given since, or a change was refused (our choice)."""
LOOKED_AT_ONCE = 25
LED_AT_ONCE = 1
"""So many are looked at before others may do something, and so many led another way (our choice: about 2 ms)."""
OF_THE_FLEET = frozenset((Purpose.GIVE_WAY, Purpose.PARK))
"""Errands that may be dropped: another one is found when one is needed."""


class Reroutes:
    """Leads vehicles another way, a few at a time: where a change of mind could close a circle of full queues, not."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        self._closed = books.closed.version
        self._version = books.router.version
        self._next_look = books.now
        self._queue: dict[VehicleId, bool] = {}
        """Who is to be looked at; whether also for a quicker way."""
        self._led_at: dict[VehicleId, Seconds] = {}
        self._quicker = 0

    @property
    def pending(self) -> bool:
        """Whether ``go_on`` has something to do."""
        return bool(self._queue)

    def run(self) -> None:
        """Have everybody under way looked at, if something has closed, or ways have other weights."""
        books = self._books
        closed, version = books.closed.version, books.router.version
        weighed = version != self._version
        if weighed:
            self._version, self._quicker = version, MOST_QUICKER
        elif closed == self._closed and (not len(books.closed) or books.now < self._next_look):
            return
        self._closed, self._next_look = closed, Seconds(books.now + LOOK_AGAIN)
        for name, vehicle in books.vehicles.items():
            if vehicle.rest:
                self._queue[name] = weighed or self._queue.get(name, False)

    def go_on(self) -> None:
        """Look at some more."""
        state = self._books.traffic_state
        led = state.led_round + state.led_quicker
        for _ in range(min(LOOKED_AT_ONCE, len(self._queue))):
            name = next(iter(self._queue))
            weighed = self._queue.pop(name)
            self._mind(self._books.vehicles[name], weighed=weighed)
            if state.led_round + state.led_quicker - led >= LED_AT_ONCE:
                break

    def _mind(self, vehicle: VehicleNow, *, weighed: bool) -> None:
        """Lead one vehicle another way: its own is closed, or (ways have been weighed anew) much slower than the best."""
        books, errand = self._books, vehicle.errand
        start = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        if errand is None or start is None or not vehicle.rest or vehicle.toward is not None:
            return
        present = [start, *vehicle.rest]
        if books.closed.on(present) is not None:
            if self._lead(vehicle, start, errand.goal):
                books.traffic_state.led_round += 1
        elif weighed and self._pays(vehicle, present, errand.goal) and self._lead(vehicle, start, errand.goal):
            self._quicker -= 1
            books.traffic_state.led_quicker += 1

    def _pays(self, vehicle: VehicleNow, present: Sequence[Barcode], goal: Barcode) -> bool:
        """Whether the best way is so much quicker than the present one that a change is worth it."""
        books = self._books
        last = self._led_at.get(vehicle.id)
        if self._quicker <= 0 or (last is not None and books.now - last < AGAIN_AFTER):
            return False
        now = books.router.along(present)
        return now - books.router.time(present[0], goal) >= max(LEAST_GAIN, LEAST_SHARE * now)

    def _lead(self, vehicle: VehicleNow, start: Barcode, goal: Barcode) -> bool:
        """Lead a vehicle by the best way; where there is none, one that is only out of the way stays where it can."""
        books, errand = self._books, vehicle.errand
        try:
            rest = books.router.route(start, goal)[1:]
        except NoRoute:
            if errand and errand.purpose in OF_THE_FLEET:
                self._motion.drop(vehicle)
            return False
        if rest == vehicle.rest or not books.traffic.turns(vehicle.id, rest):
            return False
        self._motion.lead(vehicle, rest)
        self._led_at[vehicle.id] = books.now
        return True
