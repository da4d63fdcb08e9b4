"""``python -m app.cli``: the same as ``hoistway``."""

from app.cli import app
from app.cli.tongue import run

run(app)
