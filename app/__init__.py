"""Hoistway: an open fleet transport controller."""
