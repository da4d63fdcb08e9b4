"""Runs from seeds in which everything goes wrong that a seed draws (QUALITY section 2)."""

from app.sim.fuzz.campaign import LEAST_SEEDS, Tally, reached
from app.sim.fuzz.plan import Plan, draw
from app.sim.fuzz.play import Outcome, play
from app.sim.fuzz.shrinking import shrunk

__all__ = ["LEAST_SEEDS", "Outcome", "Plan", "Tally", "draw", "play", "reached", "shrunk"]
