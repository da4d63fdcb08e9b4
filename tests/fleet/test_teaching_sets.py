"""Every teaching event joins a set, and every set ends in a state that people see; nothing is lost (I39-I41)."""

from dataclasses import replace

from app.domain.events import TeachingKind
from app.domain.layout import Axis
from app.domain.records import TeachingEvent
from app.domain.requests import WriteDest, WriteOffset
from app.domain.teaching import ProposalState, Side
from app.domain.teaching_requests import AssignProposal, StartTeaching
from app.domain.units import Barcode
from app.domain.view import ProposalView, Topic
from tests.fleet.script import B1, P1, P2, P3, V1, Script, small, words
from tests.fleet.teaching import KIM, MANT, Teacher, approve, dest, last, named, offset, opened, pulses

S = ProposalState
SHFT, ROTA, LIFT = TeachingKind.SHFT_DEST, TeachingKind.ROTA_DEST, TeachingKind.LIFT_DEST


def shared() -> Script:
    """The small plant with P2 at the barcode of P1."""
    plant = small()
    stations = tuple(replace(s, barcode=Barcode("104")) if s.id == P2 else s for s in plant.stations)
    return Script(replace(plant, stations=stations))


def axes_of(script: Script, number: int = 1) -> dict[Axis, int]:
    return {r.axis: r.position for r in named(script, number).readings}


# -- one set ----------------------------------------------------------------------------------------------------------------


def test_three_axes_are_a_set_at_once_and_wait_for_approval(script: Script) -> None:
    proposal = Teacher(script).teach(1210, -304, 41120)
    assert (proposal.state, proposal.side, proposal.station, proposal.base) == (S.READY, Side.DEST, P1, 1)
    assert proposal.result == pulses(1200, -300, 41000)
    assert [e.number for e in script.kept(TeachingEvent)] == [1, 2, 3]
    assert script.events()[-1] == "TeachingTaken"
    shown = script.model[Topic.TEACHING]["proposal-1"]
    assert isinstance(shown, ProposalView)
    assert (shown.state, shown.events, shown.missing) == ("ready", (1, 2, 3), ())


def test_events_out_of_order_still_make_the_set(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(LIFT, 41120)
    teacher.send(SHFT, 1210)
    teacher.send(ROTA, -304)
    assert last(script).state is S.READY
    assert axes_of(script) == {Axis.SHFT: 1210, Axis.ROTA: -304, Axis.LIFT: 41120}


def test_a_set_waits_ten_seconds_for_more_axes_and_is_then_a_partial_teaching(script: Script) -> None:
    Teacher(script).send(LIFT, 41500)
    script.wait(9)
    assert named(script, 1).state is S.COLLECTING
    assert script.refuse(approve(named(script, 1))).reason.endswith("more may follow")
    script.wait(2)
    proposal = named(script, 1)
    assert proposal.state is S.READY
    assert proposal.result == pulses(1200, -300, 41380)


def test_an_axis_taught_again_within_the_set_counts_and_the_event_before_stays_named(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(LIFT, 41500)
    teacher.send(LIFT, 41510)
    script.wait(11)
    (reading,) = named(script, 1).readings
    assert (reading.position, reading.events) == (41510, (1, 2))


def test_what_comes_later_than_the_window_is_a_set_of_its_own_and_the_older_is_superseded(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(LIFT, 41500)
    script.wait(11)
    teacher.send(LIFT, 41510)
    script.wait(11)
    assert (named(script, 1).state, named(script, 1).reason) == (S.SUPERSEDED, "by proposal 2")
    assert named(script, 2).state is S.READY
    assert "proposal-1" not in script.model[Topic.TEACHING]


def test_a_later_lift_does_not_supersede_a_set_with_more_axes(script: Script) -> None:
    teacher = Teacher(script)
    teacher.teach(1210, -304, 41120)
    script.wait(11)
    teacher.send(LIFT, 41510)
    script.wait(11)
    assert named(script, 1).state is S.READY


def test_dest_and_offset_and_two_barcodes_do_not_mix(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(SHFT, 1)
    teacher.send(TeachingKind.ROTA_OFFSET, 2)
    teacher.send(LIFT, 3, at="106")
    assert {named(script, n).side for n in (1, 3)} == {Side.DEST}
    assert named(script, 2).side is Side.OFFSET
    assert named(script, 3).station == P2


# -- repetitions and restarts ---------------------------------------------------------------------------------------------


def test_the_same_event_again_is_acknowledged_and_changes_nothing(script: Script) -> None:
    teacher = Teacher(script)
    first = teacher.send(LIFT, 41500)
    script.hear(replace(first, receipt=77))
    assert len(script.kept(TeachingEvent)) == 1
    assert (V1, 77) in script.stored
    assert len(last(script).readings[0].events) == 1


def test_a_counter_that_restarted_after_a_reset_loses_no_event(script: Script) -> None:
    teacher = Teacher(script)
    teacher.teach(1210, -304, 41120)
    script.link_down(V1)
    script.wait(11)
    script.link_up(V1)
    script.report(V1, "104", MANT)
    teacher.connection, teacher.counter = 2, 0
    teacher.teach(1210, -304, 41120)
    assert len(script.kept(TeachingEvent)) == 6
    assert last(script).number == 2
    teacher.counter = 0
    teacher.send(SHFT, 1300)
    assert len(script.kept(TeachingEvent)) == 7


def test_an_event_sent_again_on_a_new_connection_is_kept_and_stays_in_its_set(script: Script) -> None:
    teacher = Teacher(script)
    teacher.teach(1210, -304, 41120)
    teacher.connection, teacher.counter = 2, 2
    teacher.send(LIFT, 41120)
    proposal = last(script)
    assert proposal.number == 1
    assert next(r for r in proposal.readings if r.axis is Axis.LIFT).events == (3, 4)


def test_sets_and_their_states_survive_a_restart(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(SHFT, 1210)
    teacher.send(ROTA, -304)
    script.restart(after=2)
    assert "proposal-1" in script.model[Topic.TEACHING]
    again = Teacher(script)
    again.counter = 5
    again.send(LIFT, 41120)
    assert (last(script).number, last(script).state) == (1, S.READY)
    assert script.kept(TeachingEvent)[-1].number == 3


def test_a_set_left_behind_by_a_restart_ends_all_the_same(script: Script) -> None:
    Teacher(script).send(SHFT, 1210)
    script.restart(after=60)
    script.wait(2)
    assert named(script, 1).state is S.READY


# -- asked for --------------------------------------------------------------------------------------------------------------


def test_a_set_that_was_asked_for_belongs_to_the_command_however_slowly_it_comes(script: Script) -> None:
    teacher = Teacher(script)
    opened(script)
    script.accept(StartTeaching(KIM, 1, Side.DEST))
    send = teacher.asked(Side.DEST)
    for kind, position in ((SHFT, 1210), (ROTA, -304), (LIFT, 41120)):
        teacher.send(kind, position)
        script.report(V1, "104", words(mode=0, oper=2))
        script.wait(8)
    proposal = last(script)
    assert (proposal.number, proposal.state, proposal.asked, proposal.asked_by) == (1, S.READY, send.cmd_id, KIM)
    assert {event.asked_by for event in script.kept(TeachingEvent)} == {KIM}


def test_a_vehicle_that_breaks_off_leaves_a_set_that_says_which_axes_are_missing(script: Script) -> None:
    teacher = Teacher(script)
    opened(script)
    script.accept(StartTeaching(KIM, 1, Side.DEST))
    teacher.send(SHFT, 1210)
    script.answer(teacher.asked(Side.DEST), "104", MANT, ok=False, reason="given up")
    proposal = last(script)
    assert (proposal.state, proposal.why) == (S.INCOMPLETE, "ROTA, LIFT did not come: given up")
    refusal = script.refuse(approve(proposal))
    assert '{"accept": ["incomplete"]}' in refusal.remedy
    script.accept(approve(proposal, S.INCOMPLETE))
    assert dest(script).pulses == pulses(1200, -300, 41000)


def test_a_vehicle_lost_in_the_middle_leaves_an_incomplete_set_that_its_return_may_complete(script: Script) -> None:
    teacher = Teacher(script)
    teacher.send(SHFT, 1210)
    teacher.send(ROTA, -304)
    script.link_down(V1, "no word for 3.5 s")
    assert last(script).why == "LIFT did not come: V001 was lost: no word for 3.5 s"
    script.link_up(V1)
    script.report(V1, "104", MANT)
    teacher.connection = 2
    teacher.send(LIFT, 41120)
    assert (last(script).number, last(script).state) == (1, S.READY)


# -- what stands against it -------------------------------------------------------------------------------------------------


def test_a_dest_taught_by_a_vehicle_without_offset_is_pending_until_the_offset_is_known() -> None:
    plant = small()
    script = Script(replace(plant, vehicles=tuple(replace(v, offset=None) for v in plant.vehicles)))
    proposal = Teacher(script).teach(1210, -304, 41120)
    assert (proposal.state, proposal.result) == (S.PENDING, None)
    assert "V001 has no OFFSET (SHFT, ROTA, LIFT)" in proposal.why
    assert "OFFSET" in script.refuse(approve(proposal)).reason
    script.accept(WriteOffset(KIM, V1, pulses(10, -4, 120)))
    proposal = named(script, 1)
    assert (proposal.state, proposal.result, proposal.against_version) == (S.READY, pulses(1200, -300, 41000), 1)


def test_an_offset_taught_where_no_dest_is_known_is_pending_until_it_is() -> None:
    plant = small()
    script = Script(replace(plant, stations=tuple(replace(s, dest=None) for s in plant.stations)))
    proposal = Teacher(script).teach(1210, -304, 41120, Side.OFFSET)
    assert (proposal.state, proposal.why.split(",")[0]) == (S.PENDING, "P1 has no DEST (SHFT")
    script.accept(WriteDest(KIM, P1, pulses(1200, -300, 41000)))
    script.accept(approve(named(script, 1)))
    assert offset(script).pulses == pulses(10, -4, 120)


def test_ports_that_share_a_barcode_are_ambiguous_until_a_person_says_which() -> None:
    script = shared()
    proposal = Teacher(script).teach(1210, -304, 41120)
    assert (proposal.state, proposal.station) == (S.AMBIGUOUS, None)
    assert "P1, P2 share barcode 104" in proposal.why
    assert script.refuse(AssignProposal(KIM, 1, P3)).field == "station"
    script.accept(AssignProposal(KIM, 1, P2))
    assert (named(script, 1).state, named(script, 1).station) == (S.READY, P2)
    script.accept(approve(named(script, 1)))
    assert dest(script, P2).version == 2


def test_an_open_session_says_which_of_the_ports_is_meant() -> None:
    script = shared()
    session = opened(script, P2)
    proposal = Teacher(script).teach(1210, -304, 41120)
    assert (proposal.station, proposal.session, proposal.state) == (P2, session.number, S.READY)


def test_a_session_elsewhere_does_not_take_events_of_another_barcode(script: Script) -> None:
    opened(script, P2)
    proposal = Teacher(script).teach(1210, -304, 41120)
    assert (proposal.station, proposal.session) == (P1, None)


def test_a_barcode_without_a_port_is_kept_and_said(script: Script) -> None:
    for at in ("103", "113", "999"):
        proposal = Teacher(script, at=at).teach(1, 2, 3)
        assert (proposal.state, proposal.station) == (S.UNKNOWN_BARCODE, None)
        assert f"no port of the plant is at barcode {at}" in proposal.why
    assert script.fleet.books.specs[B1].barcode == "113"


def test_an_event_in_another_mode_than_mant_needs_a_person_to_accept_that(script: Script) -> None:
    script.stand(V1, "104")
    proposal = Teacher(script, mant=False).teach(1210, -304, 41120)
    assert (proposal.state, proposal.why) == (S.WRONG_MODE, "V001 sent it in AUTO, and teaching needs MANT")
    script.accept(approve(proposal, S.WRONG_MODE))
    assert dest(script).version == 2


def test_a_position_outside_the_vehicles_limits_is_out_of_range(script: Script) -> None:
    proposal = Teacher(script).teach(1210, -304, 100_001)
    assert (proposal.state, proposal.why) == (S.OUT_OF_RANGE, "LIFT 100001 is outside 0..100000 of V001")
    assert script.refuse(approve(proposal)).reason.startswith("proposal 1 is out_of_range")


def test_a_value_that_puts_another_vehicle_out_of_range_is_a_warning(script: Script) -> None:
    proposal = Teacher(script).teach(1210, -304, 150)
    assert proposal.state is S.READY
    assert "out of range for V002: LIFT -50 is outside 0..100000" in proposal.warnings
    assert any("far from version 1: LIFT by -40970" in warning for warning in proposal.warnings)


def test_an_unknown_code_is_kept_and_told_and_makes_no_set(script: Script) -> None:
    teacher = Teacher(script)
    event = replace(teacher.send(LIFT, 1), kind=None, code=0x2079, cmd_id=teacher.send(ROTA, 1).cmd_id)
    script.forget()
    script.hear(event)
    assert script.events() == ["TeachingCodeUnknown"]
    assert "2079" in script.history()[0].detail
    assert script.kept(TeachingEvent)[0].axis is None
    assert script.stored


def test_a_set_of_a_vehicle_that_left_the_plant_stays_and_says_so(script: Script) -> None:
    Teacher(script).teach(1210, -304, 41120)
    plant = small()
    script.restart(plant=replace(plant, vehicles=plant.vehicles[1:]))
    assert "not in the plant any more" in script.refuse(approve(named(script, 1))).reason
