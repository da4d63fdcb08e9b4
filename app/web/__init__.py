"""The operator page as built from ``web/``: ``index.html`` with ``assets``; ``manifest.json`` says from which sources."""

from pathlib import Path

PAGE = Path(__file__).parent
"""Where the built page lies."""
