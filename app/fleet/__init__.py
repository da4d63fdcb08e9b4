"""Decisions: which vehicle, which way, what next, and what to do when something went wrong. Sans-I/O."""

from app.fleet.core import Fleet
from app.fleet.effects import Effects

__all__ = ["Effects", "Fleet"]
