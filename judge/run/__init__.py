"""Judging one submission: executing, comparing, measuring."""
