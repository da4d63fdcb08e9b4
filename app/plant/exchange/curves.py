"""How long a drawn curve is."""

from collections.abc import Sequence
from itertools import pairwise
from math import comb, hypot

import numpy as np

Spot = tuple[float, float]
STEPS = 200
"""Straight pieces by which a curve is measured: 0.01 % of a half circle. Our choice."""


def polyline(spots: Sequence[Spot]) -> float:
    """Return the length of straight pieces from spot to spot."""
    return sum(hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(spots))


def bezier(spots: Sequence[Spot]) -> float:
    """Return the length of the Bézier curve with these control points."""
    degree = len(spots) - 1
    along = np.linspace(0.0, 1.0, STEPS + 1)
    weights = [comb(degree, i) * along**i * (1 - along) ** (degree - i) for i in range(degree + 1)]
    x = sum(weight * spot[0] for weight, spot in zip(weights, spots, strict=True))
    y = sum(weight * spot[1] for weight, spot in zip(weights, spots, strict=True))
    return float(np.hypot(np.diff(x), np.diff(y)).sum())


def nurbs(spots: Sequence[Spot], weights: Sequence[float], knots: Sequence[float], degree: int) -> float:
    """Return the length of a NURBS from its first to its last knot. Raises: ValueError: no such curve, in a sentence."""
    if degree < 1 or len(spots) <= degree:
        raise ValueError(f"degree {degree} needs more than {degree} control points, there are {len(spots)}")
    if len(knots) != len(spots) + degree + 1:
        raise ValueError(f"the knot vector has {len(knots)} values where {len(spots) + degree + 1} are needed")
    if any(b < a for a, b in pairwise(knots)) or knots[degree] >= knots[len(spots)]:
        raise ValueError("the knot vector does not rise")
    if min(weights) <= 0:
        raise ValueError("a weight is not above 0")
    # Loading scipy's splines takes longer than reading most layouts.
    from scipy.interpolate import BSpline

    held = np.array([(x * w, y * w, w) for (x, y), w in zip(spots, weights, strict=True)])
    along = np.linspace(knots[degree], knots[len(spots)], STEPS + 1)
    drawn = BSpline(np.array(knots, dtype=float), held, degree)(along)
    flat = drawn[:, :2] / drawn[:, 2:]
    return float(np.hypot(*np.diff(flat, axis=0).T).sum())
