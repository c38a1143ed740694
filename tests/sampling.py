"""Which parameters of a test are run every day, and which by night."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def nightly(*values: Any) -> Any:
    """A parameter that only the nightly run asks about."""
    return pytest.param(*values, marks=pytest.mark.nightly)


def daily(values: Iterable[Any], chosen: Collection[Any]) -> list[Any]:
    """All values as parameters, of which only the chosen ones are run by day."""
    values = list(values)
    assert set(map(str, chosen)) <= set(map(str, values)), "a chosen value is no parameter"
    return [value if value in chosen else nightly(value) for value in values]
