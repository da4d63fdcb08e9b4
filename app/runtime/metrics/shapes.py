"""Families of Prometheus from plain values."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeVar

from prometheus_client.metrics_core import CounterMetricFamily, GaugeMetricFamily, HistogramMetricFamily, Metric

from app.runtime.metrics.spread import Spread

PREFIX = "hoistway_"
Key = TypeVar("Key", bound=tuple[str, ...])


def gauge(name: str, what: str, value: float) -> Metric:
    """Return what may rise and fall."""
    return GaugeMetricFamily(PREFIX + name, what, value=float(value))


def gauges(name: str, what: str, labels: Sequence[str], values: Mapping[Key, float]) -> Metric:
    """Return the same by labels."""
    family = GaugeMetricFamily(PREFIX + name, what, labels=labels)
    for key, value in values.items():
        family.add_metric(key, float(value))
    return family


def counter(name: str, what: str, value: float) -> Metric:
    """Return what only rises, since the controller started; the name gets ``_total``."""
    return CounterMetricFamily(PREFIX + name, what, value=float(value))


def counters(name: str, what: str, labels: Sequence[str], values: Mapping[Key, float]) -> Metric:
    """Return the same by labels."""
    family = CounterMetricFamily(PREFIX + name, what, labels=labels)
    for key, value in values.items():
        family.add_metric(key, float(value))
    return family


def histogram(name: str, what: str, spread: Spread) -> Metric:
    """Return a histogram."""
    return HistogramMetricFamily(PREFIX + name, what, buckets=spread.buckets(), sum_value=spread.total)


def histograms(name: str, what: str, labels: Sequence[str], spreads: Iterable[tuple[Key, Spread]]) -> Metric:
    """Return a histogram by labels."""
    family = HistogramMetricFamily(PREFIX + name, what, labels=labels)
    for key, spread in spreads:
        family.add_metric(key, spread.buckets(), spread.total)
    return family


def alone(values: Mapping[str, float]) -> Mapping[tuple[str, ...], float]:
    """Return values by one label."""
    return {(key,): value for key, value in values.items()}
