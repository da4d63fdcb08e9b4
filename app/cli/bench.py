"""``hoistway bench``: what this program does on this machine, measured."""

import typer

commands = typer.Typer(help="Measure this program on this machine.", no_args_is_help=True)


@commands.callback()
def _bench() -> None:
    """Keep the name of a measurement a word of its own, even while there is only one."""
