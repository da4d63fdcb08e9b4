"""The program: composes everything by way of its commands, and is imported by nothing."""

from app.cli import app


def main() -> None:
    """Run the command line."""
    app()


if __name__ == "__main__":
    main()
