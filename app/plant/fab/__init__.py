"""A seeded generator of whole fabs: bays of one-way loops on a spine of two lanes each way."""

from app.plant.fab.chains import chains
from app.plant.fab.generate import Fab, generate
from app.plant.fab.populate import populate
from app.plant.fab.shape import SIZES, Shape
from app.plant.fab.statistics import Statistics, statistics
from app.plant.fab.writing import write

__all__ = ["SIZES", "Fab", "Shape", "Statistics", "chains", "generate", "populate", "statistics", "write"]
