"""``hoistway schema plant``: the JSON schema by which an editor completes and checks a file."""

from __future__ import annotations

from typing import Annotated

import typer

from app.cli.tongue import say


def schema(what: Annotated[str, typer.Argument(help="which kind: plant")] = "plant") -> None:
    """Print the JSON schema of a kind of file."""
    from app.plant import schema_text
    from app.wire.names import unknown

    texts = {"plant": schema_text}
    if what not in texts:
        say(unknown("kind of file", what, texts))
        raise typer.Exit(2)
    print(texts[what](), end="")
