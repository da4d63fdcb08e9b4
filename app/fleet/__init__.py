"""Decisions: which vehicle, which way, what next, and what to do when something went wrong. Sans-I/O."""

from app.fleet.books import Effects
from app.fleet.core import Fleet

__all__ = ["Effects", "Fleet"]
