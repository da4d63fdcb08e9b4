"""``hoistway openapi``: write the descriptions of the API, or check that the committed ones are up to date."""

import subprocess
import sys
from pathlib import Path
from typing import Annotated

import typer

from app.cli.tongue import say

COMMITTED = Path("openapi/openapi.json")
STREAM = "asyncapi.yaml"
"""The description of the live stream, beside the other."""
CLIENT = Path("tools/client.py")
"""Makes the Python client from the document, where this is the project's own directory."""
WIDTH = 130


def openapi(
    file: Annotated[Path, typer.Argument(help="Where it is, or goes; asyncapi.yaml beside it.")] = COMMITTED,
    *,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; fail if a file is out of date.")] = False,
) -> None:
    """Write the descriptions of the REST API (OpenAPI) and of the live stream (AsyncAPI), and in the project's own directory
    the Python client made from the former.
    """
    texts = {file: document(), file.with_name(STREAM): stream_document()}
    if not check:
        file.parent.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            name.write_text(text, encoding="utf-8")
            say(f"wrote {name}")
        if file == COMMITTED and CLIENT.is_file():
            subprocess.run([sys.executable, "-m", "tools.client"], check=True)
        return
    for name, text in texts.items():
        if not name.is_file() or name.read_text(encoding="utf-8") != text:
            say(f"{name} is out of date: run `hoistway openapi` and commit it", wrong=True)
            raise typer.Exit(1)
        say(f"{name} is up to date")


def document() -> str:
    """Return the OpenAPI document as it is committed."""
    import json

    from app.api.application import described
    from app.settings import Settings

    return json.dumps(described(Settings()).openapi(), indent=2, ensure_ascii=False) + "\n"


def stream_document() -> str:
    """Return the AsyncAPI document as it is committed."""
    import yaml

    from app.api import stream_declared
    from app.api.application import VERSION

    class Plain(yaml.SafeDumper):
        """Texts of several lines as they are read, nothing by reference."""

        def ignore_aliases(self, data: object) -> bool:
            """Write everything out."""
            return True

    def text(dumper: yaml.SafeDumper, value: str) -> yaml.ScalarNode:
        return dumper.represent_scalar("tag:yaml.org,2002:str", value, style="|" if "\n" in value else None)

    Plain.add_representer(str, text)
    written: str = yaml.dump(
        stream_declared.document(VERSION), Dumper=Plain, sort_keys=False, allow_unicode=True, width=WIDTH
    )
    return written
