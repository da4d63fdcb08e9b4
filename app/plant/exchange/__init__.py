"""Layouts of other systems: read into plant files with a report of every repair, and written from plants with what is lost."""
