"""Hypothesis' first draw reads all modules of ours that are new, which would count as a slow strategy."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st


@settings(max_examples=1, database=None, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers())
def first_draw(_: int) -> None:
    """To be called before the draws whose time counts."""
