"""A generated fab as the text of a plant file."""

from app.domain.layout import Plant
from app.plant import writing


def write(plant: Plant) -> str:
    """Return the plant file that reads back as this plant, headed as generated."""
    head = [f"A generated fab (hoistway fab): {len(plant.points)} barcodes, {len(plant.vehicles)} hoists."]
    return writing.write(plant, head)
