"""Whatever is asked in whatever order: records never contradict each other, and every job ends in one known way."""

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from app.domain.ids import Actor, JobId, StationId, VehicleId
from app.domain.job import JOB_STEPS, JobState
from app.domain.layout import StopAction
from app.domain.requests import (
    AbortJob,
    CancelJob,
    ChangeJob,
    CreateJob,
    HandleOnce,
    HoldVehicle,
    LockVehicle,
    MoveVehicle,
    PauseController,
    RecoverAlarm,
    ReleaseVehicle,
    ResumeController,
    SetService,
    UnlockVehicle,
    Verdict,
    WriteStation,
)
from app.domain.units import Barcode
from tests.fleet.script import B1, B2, FOUP1, FOUP2, HOST, P1, P2, P3, V1, V2, Script, transfer

KIM = Actor("kim")
PLACES = st.sampled_from([P1, P2, P3, B1, B2])
VEHICLES = st.sampled_from([V1, V2])
NAMES = st.sampled_from([JobId(f"J{n}") for n in range(12)])


class Plant(RuleBasedStateMachine):
    """Two obedient vehicles, a host and a person who do as they like."""

    def __init__(self) -> None:
        super().__init__()
        self.script = Script()
        self.script.world[P1] = FOUP1
        self.script.world[B1] = FOUP2
        self.script.obey()

    # -- the host -----------------------------------------------------------------------------------------------------

    @rule(
        name=NAMES,
        source=st.sampled_from([P1, B1, P3, P2, B2, V1, V2]),
        destination=st.sampled_from([P3, B2, P2, P1, B1]),
        wish=st.sampled_from([None, None, None, V1, V2]),
        fallbacks=st.lists(PLACES, max_size=2),
        priority=st.sampled_from([10, 50, 90]),
    )
    def order(
        self,
        name: JobId,
        source: str,
        destination: StationId,
        wish: VehicleId | None,
        fallbacks: list[StationId],
        priority: int,
    ) -> None:
        more = {"vehicle": wish, "fallbacks": tuple(fallbacks), "priority": priority}
        self._order(transfer(source, destination, name, **more))

    def _order(self, request: CreateJob) -> None:
        """Order, unless the database knows an ended job of that name, where the API answers from."""
        known = self.script.ledger.job(request.job) if request.job else None
        if known is None or not known.state.terminal:
            self.script.ask(request)

    @rule(name=NAMES)
    def cancel(self, name: JobId) -> None:
        self.script.ask(CancelJob(HOST, name))

    @rule(name=NAMES)
    def abort(self, name: JobId) -> None:
        self.script.ask(AbortJob(HOST, name))

    @rule(
        name=NAMES,
        destination=st.one_of(st.none(), PLACES),
        vehicle=st.one_of(st.none(), VEHICLES),
        priority=st.one_of(st.none(), st.just(70)),
    )
    def change(
        self, name: JobId, destination: StationId | None, vehicle: VehicleId | None, priority: int | None
    ) -> None:
        self.script.ask(ChangeJob(HOST, name, priority, destination, vehicle))

    @rule(station=PLACES, reserved=st.sampled_from(["", "J1", "else"]), closed=st.sampled_from(["", "dirty"]))
    def write_station(self, station: StationId, reserved: str, closed: str) -> None:
        self.script.ask(WriteStation(HOST, station, reserved=reserved, out_of_service=closed))

    @rule(station=PLACES)
    def look(self, station: StationId) -> None:
        """The host tells what is there."""
        self._tell(station)

    def _tell(self, station: StationId) -> None:
        """Tell what is at a station, unless a gripper is just about to change it."""
        if not any(toy.handling for toy in self.script.toys.values()):
            carrier = self.script.world.get(station)
            self.script.ask(WriteStation(HOST, station, present=carrier is not None, carrier=carrier))

    # -- people -------------------------------------------------------------------------------------------------------

    @rule(vehicle=VEHICLES, reason=st.sampled_from(["", "belt"]))
    def service(self, vehicle: VehicleId, reason: str) -> None:
        self.script.ask(SetService(KIM, vehicle, reason))

    @rule(vehicle=VEHICLES)
    def lock(self, vehicle: VehicleId) -> None:
        self.script.ask(LockVehicle(KIM, vehicle, "wheel"))

    @rule(vehicle=VEHICLES)
    def unlock(self, vehicle: VehicleId) -> None:
        self.script.ask(UnlockVehicle(KIM, vehicle))

    @rule(vehicle=VEHICLES)
    def hold(self, vehicle: VehicleId) -> None:
        self.script.ask(HoldVehicle(KIM, vehicle, "noise"))

    @rule(vehicle=VEHICLES)
    def release(self, vehicle: VehicleId) -> None:
        self.script.ask(ReleaseVehicle(KIM, vehicle, Verdict.GO_ON, "looked"))

    @rule()
    def pause(self) -> None:
        self.script.ask(PauseController(KIM, "drill"))

    @rule()
    def resume(self) -> None:
        self.script.ask(ResumeController(KIM))

    @rule(
        vehicle=VEHICLES,
        barcode=st.sampled_from(["104", "106", "113", "115", "108"]),
        action=st.sampled_from([StopAction.STOP, StopAction.PORT, StopAction.SBFL]),
    )
    def move(self, vehicle: VehicleId, barcode: str, action: StopAction) -> None:
        self.script.ask(MoveVehicle(KIM, vehicle, Barcode(barcode), action))

    @rule(vehicle=VEHICLES, station=PLACES, pickup=st.booleans())
    def handle(self, vehicle: VehicleId, station: StationId, pickup: bool) -> None:
        self.script.ask(HandleOnce(KIM, vehicle, station, pickup))

    # -- what happens -------------------------------------------------------------------------------------------------

    @rule(seconds=st.sampled_from([0.25, 1, 4, 15, 40]))
    def wait(self, seconds: float) -> None:
        self.script.run(seconds)

    @rule(seconds=st.sampled_from([2, 6, 10, 25]))
    def wait_a_little(self, seconds: float) -> None:
        self.script.run(seconds)

    @rule(name=NAMES, source=st.sampled_from([P1, B1]), destination=st.sampled_from([P3, B2, P2]))
    def order_plainly(self, name: JobId, source: str, destination: StationId) -> None:
        self._order(transfer(source, destination, name))
        self.script.run(3)

    @rule(vehicle=VEHICLES)
    def cut(self, vehicle: VehicleId) -> None:
        if self.script.toys[vehicle].linked:
            self.script.toys[vehicle].cut()

    @rule(vehicle=VEHICLES)
    def connect(self, vehicle: VehicleId) -> None:
        if not self.script.toys[vehicle].linked:
            self.script.toys[vehicle].connect()

    @rule(vehicle=VEHICLES, refuse=st.booleans())
    def refuse(self, vehicle: VehicleId, refuse: bool) -> None:
        self.script.toys[vehicle].reject_handling = refuse

    @precondition(lambda self: any(not toy.alarm for toy in self.script.toys.values()))
    @rule(vehicle=VEHICLES)
    def alarm(self, vehicle: VehicleId) -> None:
        self.script.toys[vehicle].stop_with(101)

    @rule(vehicle=VEHICLES)
    def recover(self, vehicle: VehicleId) -> None:
        self.script.ask(RecoverAlarm(KIM, vehicle, confirmed=True))

    @rule()
    def restart(self) -> None:
        self.script.restart()

    # -- what must hold -----------------------------------------------------------------------------------------------

    @invariant()
    def no_two_vehicles_are_at_one_barcode(self) -> None:
        places = [toy.barcode for toy in self.script.toys.values()]
        assert len(places) == len(set(places)), places

    @invariant()
    def carriers_are_conserved(self) -> None:
        carriers = [*self.script.world.values(), *(t.aboard for t in self.script.toys.values() if t.aboard)]
        assert sorted(str(carrier) for carrier in carriers) == [FOUP1, FOUP2]

    def teardown(self) -> None:
        """Everything is mended: every job goes on or says why it does not, and ends when asked to."""
        for _ in range(3):
            self._mend()
            self.script.run(150, step=0.5)
        for job in list(self.script.fleet.books.jobs.values()):
            vehicle = self.script.fleet.books.vehicles.get(job.vehicle) if job.vehicle else None
            assert job.reason or (vehicle and vehicle.waiting), job
            self.script.ask(CancelJob(HOST, job.id))
            self.script.ask(AbortJob(HOST, job.id))
        self._mend()
        self.script.run(60, step=0.5)
        assert not self.script.fleet.books.jobs, list(self.script.fleet.books.jobs.values())

    def _mend(self) -> None:
        script = self.script
        script.ask(ResumeController(KIM))
        for station in (P1, P2, P3, B1, B2):
            script.ask(WriteStation(HOST, station, reserved="", out_of_service=""))
            self._tell(station)
        for name, toy in script.toys.items():
            toy.reject_handling = False
            if not toy.linked:
                toy.connect()
            script.run(3)
            script.ask(UnlockVehicle(KIM, name))
            script.ask(SetService(KIM, name, ""))
            if toy.alarm or toy.mode != 3:
                script.ask(RecoverAlarm(KIM, name, confirmed=True))
            script.run(8)
            if script.vehicle(name).record.hold:
                script.ask(ReleaseVehicle(KIM, name, Verdict.GO_ON, "looked"))
            script.run(5)


Plant.TestCase.settings = settings(
    max_examples=25, stateful_step_count=30, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
test_any_order_of_requests_and_mishaps = Plant.TestCase


def test_states_of_a_job_that_are_terminal_have_no_way_on() -> None:
    assert not [pair for pair in JOB_STEPS if pair[0].terminal]
    assert {before for before, _ in JOB_STEPS} == {state for state in JobState if not state.terminal}
