"""The steps from an empty database to the newest schema (Alembic). Packaged beside ``app``."""
