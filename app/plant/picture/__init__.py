"""A plant as a picture: composed once as a list of shapes, written as SVG by hand or painted as PNG with Pillow."""

from app.plant.picture.compose import Look, compose
from app.plant.picture.png import has_wide_letters, png
from app.plant.picture.svg import svg

__all__ = ["Look", "compose", "has_wide_letters", "png", "svg"]
