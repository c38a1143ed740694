"""What the property tests share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import flint
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st


@settings(max_examples=1, database=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers())
def _first(_: int) -> None:
    """The first draw of a process reads all of our modules, which would count as a slow strategy."""


@pytest.fixture(scope="session", autouse=True)
def _warm() -> None:
    _first()


@pytest.fixture(autouse=True)
def _plain_precision_and_own_cache(built: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    before = flint.ctx.prec
    yield
    flint.ctx.prec = before
