"""The catalogues that a plant's drives need: found beside the plant file, or among our own."""

from __future__ import annotations

from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.plainly import FileInError, text_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from app.domain.layout import Plant
    from app.plant import Finding

DIRECTORY = "catalogues"


def catalogue_file(model: str, plant_file: Path) -> Path | None:
    """Return the file of a model's catalogue: ``catalogues/MODEL.yaml`` beside the plant file, else our own; None: neither."""
    if not model.replace("-", "").replace("_", "").isalnum():
        return None
    own = Path(str(files("app"))) / DIRECTORY / f"{model}.yaml"
    return next((file for file in (plant_file.parent / DIRECTORY / f"{model}.yaml", own) if file.is_file()), None)


def with_catalogues(plant: Plant, plant_file: Path) -> tuple[Plant, list[tuple[Path, Finding]], bool]:
    """Return the plant with the catalogues of its drives, what was found wrong with them, and whether all can be used.

    A drive whose model has no catalogue is a warning, at the plant file. Raises CannotStart: a file cannot be read.
    """
    return with_texts(plant, plant_file, catalogue_texts(plant, plant_file))


def catalogue_texts(plant: Plant, plant_file: Path) -> dict[str, str]:
    """Return the texts of the catalogues that a plant's drives need and that there are, by model. Raises CannotStart."""
    files = {drive.model: catalogue_file(drive.model, plant_file) for drive in plant.drives if drive.model}
    return {model: text_of(file) for model, file in files.items() if file is not None}


def with_texts(
    plant: Plant, plant_file: Path, texts: Mapping[str, str]
) -> tuple[Plant, list[tuple[Path, Finding]], bool]:
    """Do as ``with_catalogues``, with catalogues that have these texts."""
    from app.plant import Finding, Severity, UnusablePlant
    from app.plant.catalogue import read_catalogue

    found, findings, usable = [], list[tuple[Path, Finding]](), True
    for model in dict.fromkeys(drive.model for drive in plant.drives if drive.model):
        if model not in texts:
            message = f"there is no catalogue {model}: its drives have raw access only"
            remedy = f"put {model}.yaml into {plant_file.parent / DIRECTORY}, or leave the model out"
            findings.append((plant_file, Finding(1, 1, Severity.WARNING, "drives", message, remedy)))
            continue
        try:
            catalogue, warnings = read_catalogue(texts[model], model)
        except UnusablePlant as unusable:
            warnings, usable = unusable.findings, False
        else:
            found.append(catalogue)
        file = catalogue_file(model, plant_file) or plant_file
        findings += ((file, finding) for finding in warnings)
    return replace(plant, catalogues=tuple(found)), findings, usable


def equipped(plant: Plant, plant_file: Path) -> Plant:
    """Return the plant with the catalogues of its drives. Raises CannotStart: one of them has errors."""
    plant, findings, usable = with_catalogues(plant, plant_file)
    if not usable:
        file, finding = next((file, finding) for file, finding in findings if finding.is_error)
        raise FileInError(f"the catalogue {file} has errors: {finding}", remedy=f"see: hoistway check {plant_file}")
    return plant
