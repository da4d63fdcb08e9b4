"""``hoistway openapi``: write the description of the API, or check that the committed one is up to date."""

import subprocess
import sys
from pathlib import Path
from typing import Annotated

import typer

COMMITTED = Path("openapi/openapi.json")
CLIENT = Path("tools/client.py")
"""Makes the Python client from the document, where this is the project's own directory."""


def openapi(
    file: Annotated[Path, typer.Argument(help="Where it is, or goes.")] = COMMITTED,
    *,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; fail if the file is out of date.")] = False,
) -> None:
    """Write the OpenAPI document of the REST API, and in the project's own directory the Python client made from it."""
    text = document()
    if not check:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        typer.echo(f"wrote {file}")
        if file == COMMITTED and CLIENT.is_file():
            subprocess.run([sys.executable, "-m", "tools.client"], check=True)
        return
    if not file.is_file() or file.read_text(encoding="utf-8") != text:
        typer.echo(f"{file} is out of date: run `hoistway openapi` and commit it", err=True)
        raise typer.Exit(1)
    typer.echo(f"{file} is up to date")


def document() -> str:
    """Return the document as it is committed."""
    import json

    from app.api.application import described
    from app.settings import Settings

    return json.dumps(described(Settings()).openapi(), indent=2, ensure_ascii=False) + "\n"
