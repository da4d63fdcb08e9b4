"""What people decide about what was taught: approve, reject, roll back, import; each once in the audit (DOMAIN section 3)."""

from app.domain.errors import Refusal
from app.domain.events import TeachingKind
from app.domain.ids import StationId, VehicleId
from app.domain.pulses import PartialPulses
from app.domain.records import AuditRow, StationDest
from app.domain.requests import WriteDest
from app.domain.teaching import Fate, ImportRow, ProposalState, Side
from app.domain.teaching_requests import (
    ApproveProposal,
    AssignProposal,
    ImportTaught,
    RejectProposal,
    RollBackDest,
    RollBackOffset,
)
from app.domain.units import Pulses
from app.domain.view import Topic
from tests.fleet.script import B1, P1, P2, V1, V2, Script
from tests.fleet.teaching import KIM, LEE, Teacher, approve, dest, named, offset, pulses, reject

S = ProposalState
NEW = pulses(1300, -200, 42000)


def line(name: str, *values: int | None, number: int = 2, version: int | None = None) -> ImportRow:
    shft, rota, lift = (None if v is None else Pulses(v) for v in values)
    given = PartialPulses(shft, rota, lift)
    full = pulses(shft, rota, lift) if shft is not None and rota is not None and lift is not None else given
    return ImportRow(number, name, full, version)


def take_over(script: Script, *rows: ImportRow, side: Side = Side.DEST) -> object:
    return script.ask(ImportTaught(KIM, side, rows))


# -- approve and reject -----------------------------------------------------------------------------------------------------


def test_approval_makes_a_version_and_the_proposal_leaves_the_live_ones(script: Script) -> None:
    script.accept(approve(Teacher(script).teach(1210, -304, 41120)))
    decided = named(script, 1)
    assert (decided.state, decided.closed_by, decided.version, decided.reason) == (S.APPROVED, KIM, 2, "as measured")
    assert "proposal-1" not in script.model[Topic.TEACHING]
    assert script.events()[-1] == "TeachingApproved"
    assert script.refuse(approve(decided)).code == "conflict"


def test_rejection_changes_nothing_but_the_proposal(script: Script) -> None:
    script.accept(reject(Teacher(script).teach(1210, -304, 41120)))
    assert (named(script, 1).state, named(script, 1).reason) == (S.REJECTED, "taught askew")
    assert dest(script).version == 1
    assert script.events()[-1] == "TeachingRejected"


def test_who_has_not_seen_the_newest_revision_is_refused(script: Script) -> None:
    seen = Teacher(script).teach(1210, -304, 41120)
    script.accept(WriteDest(KIM, P1, NEW))
    assert named(script, 1).revision > seen.revision
    for request in (
        ApproveProposal(KIM, 1, expected=seen.revision),
        RejectProposal(KIM, 1, "x", expected=seen.revision),
        AssignProposal(KIM, 1, P1, expected=seen.revision),
    ):
        assert script.refuse(request).code == "stale"
    script.accept(ApproveProposal(LEE, 1, expected=named(script, 1).revision))
    assert (dest(script).version, dest(script).actor) == (3, "lee")


def test_only_some_states_can_be_accepted(script: Script) -> None:
    proposal = Teacher(script, at="103").teach(1, 2, 3)
    refusal = script.refuse(approve(proposal, S.UNKNOWN_BARCODE))
    assert (refusal.code, refusal.field) == ("invalid", "accept")
    assert "incomplete" in refusal.remedy


def test_every_decision_has_one_audit_row_with_its_words(script: Script) -> None:
    proposal = Teacher(script).teach(1210, -304, 41120)
    script.forget()
    script.accept(approve(proposal))
    script.refuse(approve(proposal))
    rows = script.kept(AuditRow)
    assert [(row.action, row.accepted, row.target) for row in rows] == [
        ("ApproveProposal", True, "proposal-1"),
        ("ApproveProposal", False, "1"),
    ]
    assert "as measured" in rows[0].detail


# -- roll back --------------------------------------------------------------------------------------------------------------


def test_a_roll_back_is_a_new_version_that_equals_the_old_with_its_origin(script: Script) -> None:
    script.accept(approve(Teacher(script).teach(1310, -204, 42120)))
    taught = dest(script)
    script.accept(WriteDest(KIM, P1, pulses(1, 2, 3)))
    script.accept(RollBackDest(LEE, P1, taught, "a typing error", expected=3))
    now = dest(script)
    assert (now.version, now.pulses, now.source, now.restores) == (4, taught.pulses, "roll-back", 2)
    assert (now.basis, now.actor, now.reason) == (taught.basis, "lee", "a typing error")
    assert script.events()[-1] == "TeachingRolledBack"
    assert script.kept(AuditRow)[-1].detail == "to version 2: a typing error"


def test_a_roll_back_to_the_present_or_of_a_stale_reader_is_refused(script: Script) -> None:
    first = dest(script)
    assert script.refuse(RollBackDest(KIM, P1, first, "x")).field == "version"
    script.accept(WriteDest(KIM, P1, NEW))
    assert script.refuse(RollBackDest(KIM, P1, first, "x", expected=1)).code == "stale"
    assert script.refuse(RollBackDest(KIM, StationId("nope"), first, "x")).code == "not-found"


def test_an_offset_rolls_back_likewise(script: Script) -> None:
    first = offset(script)
    script.accept(approve(Teacher(script).teach(1215, -304, 41120, Side.OFFSET)))
    assert offset(script).pulses.shft == 15
    script.accept(RollBackOffset(KIM, V1, first, "worse than before", expected=2))
    assert (offset(script).version, offset(script).pulses, offset(script).restores) == (3, first.pulses, 1)
    assert script.refuse(RollBackOffset(KIM, V1, offset(script), "x")).field == "version"
    assert script.refuse(RollBackOffset(KIM, V1, first, "x", expected=1)).code == "stale"
    assert script.refuse(RollBackOffset(KIM, VehicleId("nope"), first, "x")).code == "not-found"


# -- import -----------------------------------------------------------------------------------------------------------------


def test_an_import_writes_what_is_new_or_changed_and_leaves_the_rest(script: Script) -> None:
    accepted = script.accept(
        ImportTaught(
            KIM,
            Side.DEST,
            (line("P1", 1200, -300, 41000), line("P2", None, None, 43000, number=3, version=1)),
        )
    )
    assert [(f.fate, f.version, f.detail) for f in accepted.fates] == [
        (Fate.SAME, 1, ""),
        (Fate.CHANGED, 2, "LIFT 41200 -> 43000; far from version 1: LIFT by +1800"),
    ]
    assert (dest(script, P2).pulses, dest(script, P2).source) == (pulses(1150, -280, 43000), "import")
    assert dest(script).version == 1
    assert [row.detail for row in script.kept(AuditRow)] == ["2 rows of dest"]
    assert script.events() == ["TeachingImported"]


def test_one_wrong_row_and_nothing_is_imported(script: Script) -> None:
    good = line("P2", 1, 2, 3, number=3)
    for bad, words in (
        (line("P9", 1, 2, 3), "there is no port P9"),
        (line(B1, 1, 2, 3), "there is no port B1"),
        (line("P2", 1, 2, 3), "P2 is on line 2 already"),
        (line("P1", 1, 2, 3, version=7), "P1 is at version 1 now, not 7"),
        (line("P1", None, None, None), "P1 has no value"),
    ):
        reply = take_over(script, bad, good)
        assert isinstance(reply, Refusal)
        assert words in reply.reason
        assert reply.reason.startswith("line ")
        assert reply.remedy
    assert not [d for d in script.kept(StationDest) if d.source == "import"]


def test_an_import_of_offsets_and_of_an_axis_alone_for_what_has_none(script: Script) -> None:
    script.accept(ImportTaught(KIM, Side.OFFSET, (line(V1, 1, 2, 3), line(V2, None, None, -90, number=3))))
    assert offset(script).pulses == pulses(1, 2, 3)
    assert offset(script, V2).pulses == pulses(-6, 2, -90)


def test_imported_axes_that_stay_as_they_were_keep_their_origin(script: Script) -> None:
    script.accept(approve(Teacher(script).teach(1310, -204, 42120)))
    script.accept(ImportTaught(KIM, Side.DEST, (line("P1", 1300, -200, 50000),)))
    assert [basis.axis.value for basis in dest(script).basis] == ["shft", "rota"]


def test_a_proposal_follows_what_was_written_meanwhile(script: Script) -> None:
    Teacher(script).send(TeachingKind.LIFT_DEST, 41120)
    script.wait(11)
    script.accept(WriteDest(KIM, P1, pulses(7, 8, 9)))
    assert (named(script, 1).base, named(script, 1).result) == (2, pulses(7, 8, 41000))
