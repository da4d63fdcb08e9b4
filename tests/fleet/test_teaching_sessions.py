"""Teaching sessions: the port is closed to jobs, the vehicle is nobody else's, and the command goes the usual way."""

from app.domain.commands import Move, Simple
from app.domain.events import TeachingKind
from app.domain.ids import StationId, VehicleId
from app.domain.records import AuditRow, HistoryEvent
from app.domain.requests import CommandVehicle, HandleOnce, LockVehicle, MoveVehicle
from app.domain.teaching import ProposalState, SessionState, Side, TeachingSession
from app.domain.teaching_requests import EndTeaching, OpenTeaching, StartTeaching
from app.domain.units import Barcode
from app.domain.view import StationView, TeachingSessionView, Topic
from tests.fleet.script import B1, P1, P2, P3, V1, V2, Script, words
from tests.fleet.teaching import KIM, LEE, MANT, Teacher, named, opened

GONE = StationId("P9")


def start(side: Side = Side.DEST, session: int = 1) -> StartTeaching:
    return StartTeaching(KIM, session, side)


def open_(station: StationId = P1, vehicle: VehicleId = V1) -> OpenTeaching:
    return OpenTeaching(KIM, station, vehicle)


# -- open -------------------------------------------------------------------------------------------------------------------


def test_a_session_is_kept_shown_and_audited_under_its_persons_name(script: Script) -> None:
    session = opened(script)
    assert (session.number, session.actor, session.note, session.state) == (1, KIM, "new tool", SessionState.OPEN)
    assert isinstance(script.model[Topic.TEACHING]["session-1"], TeachingSessionView)
    station = script.model[Topic.STATIONS][P1]
    assert isinstance(station, StationView)
    assert station.teaching == 1
    assert script.events() == ["TeachingSessionOpened"]
    assert [row.action for row in script.kept(AuditRow)] == ["OpenTeaching"]


def test_what_cannot_be_taught_is_refused(script: Script) -> None:
    assert script.refuse(open_(GONE)).field == "station"
    assert "no port" in script.refuse(open_(B1)).reason
    assert script.refuse(open_(vehicle=VehicleId("V9"))).field == "vehicle"


def test_a_port_and_a_vehicle_are_in_one_session_at_a_time(script: Script) -> None:
    opened(script)
    assert "session 1" in script.refuse(open_(vehicle=V2)).reason
    assert "session 1" in script.refuse(open_(P2)).reason
    opened(script, P2, V2)


def test_a_session_survives_a_restart(script: Script) -> None:
    opened(script)
    script.restart()
    assert script.vehicle(V1).teaching == 1
    assert "session-1" in script.model[Topic.TEACHING]
    script.accept(EndTeaching(KIM, 1))
    assert opened(script).number == 2


def test_a_port_where_a_carrier_is_being_handled_is_not_opened(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("acquiring")
    refusal = ready.refuse(open_(vehicle=V2))
    assert refusal.reason == "V001 is handling a carrier at P1"
    assert "on job J1" in ready.refuse(open_(P2)).reason


def test_a_vehicle_on_its_way_to_fetch_gives_its_job_back(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_source")
    opened(ready, P2)
    assert ready.vehicle(V1).job is None
    assert ready.job("J1").state.value == "queued"
    ready.run(3)
    assert "used for teaching (session 1)" in ready.job("J1").reason


# -- while it is open -------------------------------------------------------------------------------------------------------


def test_jobs_from_and_to_the_port_wait_with_the_reason_and_run_afterwards(ready: Script) -> None:
    opened(ready, P1, V2)
    ready.order("P1", "P3")
    ready.run(5)
    assert ready.job("J1").reason == "P1 is being taught by kim with V002 (teaching session 1)"
    ready.accept(EndTeaching(KIM, 1))
    ready.run_until("J1")
    assert ready.job("J1").state.value == "completed"


def test_a_vehicle_on_its_way_to_put_down_there_waits_or_takes_a_fallback(ready: Script) -> None:
    ready.order("P1", "P3", vehicle=V1)
    ready.run_to("to_destination")
    opened(ready, P3, V2)
    ready.run(20)
    assert "P3 is being taught" in ready.job("J1").reason
    ready.accept(EndTeaching(KIM, 1))
    ready.run_until("J1")
    assert ready.job("J1").destination == P3


def test_the_sessions_vehicle_is_given_no_job_and_is_not_sent_out_of_the_way(ready: Script) -> None:
    opened(ready, P2, V1)
    ready.order("P1", "P3")
    ready.run(5)
    assert ready.job("J1").vehicle == V2
    ready.forget()
    ready.run(30)
    assert not [s for s in ready.sends if isinstance(s.command, Move) and s.vehicle == V1]


def test_a_person_may_drive_it_there_and_try_the_taught_values(ready: Script) -> None:
    opened(ready, P1, V1)
    ready.accept(MoveVehicle(KIM, V1, Barcode("104"), ready.fleet.books.specs[P1].kind.stop_action))
    ready.run(20)
    ready.accept(HandleOnce(KIM, V1, P1, pickup=True))
    ready.run(20)
    assert ready.vehicle(V1).loaded
    ready.accept(HandleOnce(KIM, V1, P1, pickup=False))


# -- start ------------------------------------------------------------------------------------------------------------------


def test_the_command_goes_the_usual_way_with_a_durable_intent(script: Script) -> None:
    Teacher(script)
    opened(script)
    reply = script.accept(start())
    send = script.last(Simple)
    assert (reply.key, reply.cmd_id) == ("session-1", send.cmd_id)
    assert script.intents(V1)[0].kind == "port_dest_teaching"
    assert "sending its positions already" in script.refuse(start(Side.OFFSET)).reason
    script.answer(send, "104", MANT)
    script.accept(start(Side.OFFSET))
    assert script.intents(V1)[0].kind == "port_offset_teaching"


def test_what_stands_against_the_command_is_said_with_what_helps(script: Script) -> None:
    opened(script)
    assert "not connected" in script.refuse(start()).reason
    script.stand(V1, "104")
    refusal = script.refuse(start())
    assert refusal.reason == "V001 is in AUTO, and port_dest_teaching needs MANT"
    assert "send stop first" in refusal.remedy
    script.report(V1, "103", MANT)
    refusal = script.refuse(start())
    assert refusal.reason == "V001 stands at 103, and P1 is at 104"
    assert "104" in refusal.remedy
    script.report(V1, "104", words(mode=0, flags=0x7))
    assert "no barcode that it reads" in script.refuse(start()).reason
    script.report(V1, "104", MANT)
    script.accept(LockVehicle(KIM, V1, "my hand is in it"))
    assert "locked out" in script.refuse(start()).reason
    assert script.refuse(start(session=9)).code == "not-found"


def test_teaching_is_told_from_the_commands_that_people_send_otherwise(script: Script) -> None:
    Teacher(script)
    script.accept(CommandVehicle(KIM, V1, Side.DEST.command))
    teacher = Teacher(script)
    proposal = teacher.teach(1210, -304, 41120)
    assert (proposal.session, proposal.asked_by) == (None, KIM)


# -- end --------------------------------------------------------------------------------------------------------------------


def test_closing_leaves_what_was_taught_for_approval_and_waits_for_nothing_more(script: Script) -> None:
    teacher = Teacher(script)
    opened(script)
    teacher.send(TeachingKind.LIFT_DEST, 41120)
    script.accept(EndTeaching(LEE, 1, "done"))
    assert named(script, 1).state is ProposalState.READY
    ended = script.kept(TeachingSession)[-1]
    assert (ended.state, ended.ended_by, ended.reason) == (SessionState.CLOSED, "lee", "done")
    assert "session-1" not in script.model[Topic.TEACHING]
    assert script.vehicle(V1).teaching is None
    assert script.refuse(EndTeaching(KIM, 1)).code == "not-found"


def test_abandoning_rejects_what_nobody_has_approved(script: Script) -> None:
    teacher = Teacher(script)
    opened(script)
    teacher.teach(1210, -304, 41120)
    script.accept(EndTeaching(KIM, 1, abandon=True))
    assert named(script, 1).state is ProposalState.REJECTED
    assert named(script, 1).reason == "session 1 was abandoned"
    assert script.kept(HistoryEvent)[-1].event == "TeachingSessionEnded"
