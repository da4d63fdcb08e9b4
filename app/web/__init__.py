"""The operator page as built from ``web/``: ``index.html`` and ``assets`` beside it; ``manifest.json`` says from which sources."""

from pathlib import Path

PAGE = Path(__file__).parent
"""Where the built page lies."""
