"""What the property tests share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import flint
import pytest
from first_draw import first_draw


@pytest.fixture(scope="session", autouse=True)
def _warm() -> None:
    first_draw()


@pytest.fixture(autouse=True)
def _plain_precision_and_own_cache(built: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    before = flint.ctx.prec
    yield
    flint.ctx.prec = before
