"""The traffic as a whole: who stands for good, what is cut off, what is slow, who waits in a circle, who is led another way."""

from app.domain.units import Seconds
from app.fleet.books import Books
from app.fleet.breakdowns import Breakdowns
from app.fleet.circles import Circles
from app.fleet.congestion import Congestion
from app.fleet.cutoff import CutOff
from app.fleet.motion import Motion
from app.fleet.reroutes import Reroutes
from app.fleet.vehicle import VehicleNow

LOOK_EVERY = Seconds(1.0)
"""How often it is looked who stands for good or in a circle: both take seconds to show (our choice)."""


class Flow:
    """Looks at the traffic, and tells people of it."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._breakdowns = Breakdowns(books)
        self._cut_off = CutOff(books, self._breakdowns)
        self._congestion = Congestion(books, motion)
        self._circles = Circles(books, motion)
        self._reroutes = Reroutes(books, motion)
        self._told = self._state
        self._next_look = books.now
        self._looks = True

    @property
    def pending(self) -> bool:
        """Whether ``go_on`` has something to do at once."""
        return self._cut_off.pending or self._reroutes.pending

    def mind(self, vehicle: VehicleNow) -> None:
        """A vehicle is different now."""
        self._breakdowns.mind(vehicle)
        self._congestion.mind(vehicle)

    def goes_on(self, vehicle: VehicleNow) -> None:
        """A vehicle is about to take its next step: what it has closed by standing is open if it can go on."""
        self._breakdowns.goes_on(vehicle)

    def before_dispatch(self) -> None:
        """See what can be reached, before jobs are given to vehicles."""
        now = self._books.now
        self._looks = now >= self._next_look
        if self._looks:
            self._next_look = Seconds(now + LOOK_EVERY)
            self._breakdowns.run()
        self._cut_off.look()

    def after_dispatch(self) -> None:
        """Untie circles, weigh ways, lead vehicles another way; show it if anything is other than it was."""
        if self._looks:
            self._circles.look()
        self._congestion.run()
        self._reroutes.run()
        if self._told != self._state:
            self._told = self._state
            self._books.show_controller()

    def go_on(self) -> None:
        """Do the next piece of what was begun."""
        if self._cut_off.pending:
            self._cut_off.go_on()
        else:
            self._reroutes.go_on()

    @property
    def _state(self) -> tuple[object, ...]:
        state = self._books.traffic_state
        led = (state.led_round, state.led_quicker)
        ways = (state.weighed, state.slow, state.restrained_to)
        return self._books.closed.edition, tuple(state.cut_off), led, ways
