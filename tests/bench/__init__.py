"""Benchmarks: each figure against a floor measured in the same run. Run them with ``make bench``."""
