"""What a start must not forget where the plant file has changed since the database was written (COMMANDS 3.1, 3.6)."""

from app.domain.errors import PlantError
from app.domain.layout import Plant
from app.domain.records import Kept


def check_nobody_is_forgotten(plant: Plant, kept: Kept) -> None:
    """See that every vehicle that may be on the rail is still in the plant.

    Raises PlantError: one is not; nobody would keep others off its track, and what it carries would be lost.
    """
    named = {spec.id for spec in plant.vehicles}
    for record in kept.vehicles:
        if record.vehicle in named or record.off_rail:
            continue
        ahead = [barcode for intent in kept.intents if intent.vehicle == record.vehicle for barcode in intent.path]
        places = list(dict.fromkeys([*record.held, *ahead]))
        if places:
            raise PlantError(
                f"vehicle {record.vehicle} is not in the plant file any more, but may be on the rail "
                f"({', '.join(places[:5])}{' ...' if len(places) > 5 else ''})",
                remedy="Put it back into the file; once it is off the rail say so (POST "
                f"/api/v1/vehicles/{record.vehicle}/release, verdict off_rail), then take it out.",
            )
