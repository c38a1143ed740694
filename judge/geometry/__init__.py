"""Exact figures of circles, lines and points: all that the judge knows of geometry."""
