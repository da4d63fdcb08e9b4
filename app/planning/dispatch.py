"""Which vehicle does which job: what a pair costs, and the cheapest pairs for all at once."""

from collections.abc import Sequence

import numpy as np
from scipy.optimize import linear_sum_assignment

DEFAULT_PRIORITY = 50
"""Of 0 to 99; more is more urgent."""
FULL_AGE = 3600.0
"""Our choice: what waiting can be worth at most, in seconds of driving."""
PRIORITY_STEP = 2 * FULL_AGE
"""Our choice: what one step of priority is worth, in seconds of driving. More than all age and an hour's drive."""
SWITCH = 30.0
"""Our choice: how many seconds a vehicle must save before it is taken off the job it has (hysteresis)."""


def cost(travel: float, age: float = 0.0, priority: int = DEFAULT_PRIORITY, *, switches: bool = False) -> float:
    """Return what it costs that a vehicle does a job, in seconds of driving: less is better, and it may be negative.

    ``travel + SWITCH (if switches) - FULL_AGE * age / (FULL_AGE + age) - PRIORITY_STEP * (priority - 50)``, with
    ``travel`` the time to the source (infinite: cannot) and ``age`` the time since the job was created, both in seconds.
    A job of higher priority comes first wherever the drives differ by less than an hour. Among equals a second of
    waiting is worth a second of driving at first, less later, never nothing and never a step of priority.
    ``switches``: the pair differs from the present assignment of the vehicle or of the job.
    """
    waited = FULL_AGE * age / (FULL_AGE + age) if age > 0 else 0.0
    return travel + SWITCH * switches - waited - PRIORITY_STEP * (priority - DEFAULT_PRIORITY)


def assign(costs: Sequence[Sequence[float]]) -> list[tuple[int, int]]:
    """Return the pairs (row, column) of least total cost among those with the most pairs, by rising row.

    Each row and each column is in one pair at most. Infinite and undefined costs are never paired. Rows have one length.
    """
    if not costs or not costs[0]:
        return []
    table = np.array(costs, dtype=np.float64)
    possible = np.isfinite(table)
    if not possible.any():
        return []
    least, most = table[possible].min(), table[possible].max()
    forbidden = (most - least + 1.0) * (min(table.shape) + 1)
    rows, columns = linear_sum_assignment(np.where(possible, table - least, forbidden))
    return [(row, column) for row, column in zip(rows.tolist(), columns.tolist(), strict=True) if possible[row, column]]
