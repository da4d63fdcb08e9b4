"""The program: composes everything by way of its commands, and is imported by nothing."""

import sys

INTERRUPTED = 130
"""What a shell expects of a program that Ctrl-C ended."""


def main() -> None:
    """Run the command line."""
    try:
        # Here, since reading the program in takes long enough for a Ctrl-C.
        from app.cli import app
        from app.cli.tongue import run

        run(app)
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)


if __name__ == "__main__":
    main()
