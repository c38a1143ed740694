"""What the property tests share."""

from __future__ import annotations

from collections.abc import Iterator

import flint
import pytest


@pytest.fixture(autouse=True)
def _plain_precision() -> Iterator[None]:
    before = flint.ctx.prec
    yield
    flint.ctx.prec = before
