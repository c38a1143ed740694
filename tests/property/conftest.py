"""What the property tests share: by day their draws are the same each time, by night they are others."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import flint
import pytest
from first_draw import first_draw
from hypothesis import settings

if "NIGHTLY" not in os.environ:  # of tests that are loaded after this
    settings.register_profile("day", derandomize=True)
    settings.load_profile("day")


@pytest.fixture(scope="session", autouse=True)
def _warm() -> None:
    first_draw()


@pytest.fixture(autouse=True)
def _plain_precision_and_own_cache(built: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    before = flint.ctx.prec
    yield
    flint.ctx.prec = before
