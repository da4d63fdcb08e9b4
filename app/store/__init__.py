"""The durable store: the only SQL. Synchronous SQLAlchemy Core on SQLite or PostgreSQL."""
