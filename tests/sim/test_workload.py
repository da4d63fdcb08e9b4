from random import Random

import pytest

from app.domain.ids import CarrierId, StationId
from app.sim.workload import Pace, choose

IDS = [StationId(name) for name in "ABCD"]
AT = {StationId("A"): CarrierId("F1"), StationId("B"): CarrierId("F2")}


def test_an_errand_goes_from_a_full_place_to_an_empty_one() -> None:
    for seed in range(20):
        errand = choose(Random(seed), IDS, AT, frozenset())
        assert errand is not None
        assert errand.source in AT
        assert errand.destination not in AT
        assert errand.carrier == AT[errand.source]


def test_places_in_a_job_are_left_alone() -> None:
    errand = choose(Random(1), IDS, AT, {StationId("A"), StationId("C")})
    assert errand is not None
    assert (errand.source, errand.destination) == ("B", "D")


def test_without_a_full_or_an_empty_place_there_is_no_errand() -> None:
    assert choose(Random(1), IDS, {}, frozenset()) is None
    assert choose(Random(1), IDS[:2], AT, frozenset()) is None


def test_so_many_jobs_are_kept_open() -> None:
    pace = Pace(Random(1), keep_open=5)
    assert pace.due(0.0, 2) == 3
    assert pace.due(1.0, 7) == 0


def test_a_rate_is_kept_on_the_average() -> None:
    pace = Pace(Random(1), per_hour=3600.0)
    assert sum(pace.due(float(second), 0) for second in range(10_000)) == pytest.approx(10_000, rel=0.05)


def test_no_rate_is_no_jobs() -> None:
    assert Pace(Random(1), per_hour=0.0).due(1e9, 0) == 0


def test_a_pace_is_a_rate_or_a_number() -> None:
    with pytest.raises(ValueError, match="either"):
        Pace(Random(1))
