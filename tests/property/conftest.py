"""What the property tests share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import flint
import pytest
from hypothesis import HealthCheck, settings

# The first draw of a process reads all of our modules: on a busy machine that is no slow strategy.
settings.register_profile("judge", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("judge")


@pytest.fixture(autouse=True)
def _plain_precision_and_own_cache(built: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    before = flint.ctx.prec
    yield
    flint.ctx.prec = before
