"""One run of a plan: a safety phase in which things go wrong, then everybody does what is asked of them until all jobs end."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from random import Random

from app.domain.layout import Plant
from app.domain.ports import Endpoint
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.simulator import RespTiming
from app.protocols.itsc.simulator.faults import Faulty, foreign_dev_id
from app.sim.agenda import Standstill
from app.sim.fuzz.blows import strike
from app.sim.fuzz.people import People
from app.sim.fuzz.plan import Plan, Strike
from app.sim.fuzz.scene import Scene
from app.wire.faults import Lane

AT_MOST = 1200.0
"""Virtual seconds in which all jobs must end once it is calm. Our choice: people pass by every few seconds."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a run. ``wrong`` says in words what must not have happened; empty means: nothing did."""

    seed: int
    wrong: tuple[str, ...]
    counts: Counter[str]
    virtual: float
    crashes: int
    jobs: int
    trace: str
    said: tuple[tuple[float, str], ...] = ()


def play(plant: Plant, plan: Plan, watch: Callable[[Scene], None] = lambda scene: None) -> Outcome:
    """Let it all happen. ``watch`` is given the scene before it begins."""
    scene = Scene(plant, plan)
    watch(scene)
    People(scene)
    if plan.answers_on_acceptance:
        _answer_on_acceptance(scene)
    _disturb(scene)
    scene.work(until=plan.calm, keep_open=plan.keep_open)
    for blow in plan.strikes:
        scene.agenda.at(blow.at, _falls(scene, blow))
    wrong: list[str] = []
    try:
        scene.run(plan.calm)
        scene.compare_views()
        scene.finish(AT_MOST)
        scene.compare_views()
    except (Standstill, AssertionError, LookupError, ValueError, TypeError, AttributeError, RuntimeError) as defect:
        wrong.append(f"at {scene.now:.3f} s: {type(defect).__name__}: {defect}")
    result = scene.result()
    wrong += result.violations
    wrong += [f"{job} has not ended" for job in result.open]
    if not wrong and scene.floor.truth.aboard and not result.open:
        scene.tell("a carrier is left aboard")
    return Outcome(
        plan.seed,
        tuple(wrong),
        scene.counts,
        scene.now,
        scene.crashes,
        result.ended,
        result.trace,
        tuple(scene.said),
    )


def _falls(scene: Scene, blow: Strike) -> Callable[[], None]:
    return lambda: strike(scene, blow)


def _answer_on_acceptance(scene: Scene) -> None:
    """Let hoists give RESP1 when they accept a command (PROTOCOLS I19)."""
    for device in scene.floor.devices.values():
        onboard = device._onboard
        onboard._options = replace(onboard._options, resp_timing=RespTiming.ACCEPTANCE)


def _disturb(scene: Scene) -> None:
    """Let packets be lost, late, doubled, damaged, cut up and mixed with noise until it is calm."""
    lanes: list[Lane] = []
    for line in sorted({line for line, _ in scene.plan.noise}):
        spec = next(spec for spec in scene.plant.hoists if spec.id == line)
        forge = foreign_dev_id(Codec(dialect_of(scene.plant, spec.dialect)))
        out, into = (
            Lane(Random(f"{scene.plan.seed}/{line}/{way}"), scene.plan.noise.get((line, way), {})) for way in "<>"
        )
        out._forge = forge
        lanes += out, into

        def behind(device: Endpoint, out: Lane = out, into: Lane = into) -> Endpoint:
            return Faulty(device, out, into)

        scene.cable(line).disturb(behind)

    def mended() -> None:
        for lane in lanes:
            lane.rates = {}

    if lanes:
        scene.tell("noise")
        scene.agenda.at(scene.plan.calm, mended)
