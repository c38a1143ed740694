"""Test data: building cases, proving promises, pinning and caching them.

The names below are imported when they are asked for: who needs only one of the files need not wait for all.
"""

from __future__ import annotations

from typing import Any

_FROM = {
    "GroupData": "model",
    "ProblemData": "model",
    "load_data": "load",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in _FROM:
        raise AttributeError(f"module 'judge.data' has no attribute {name!r}")
    return getattr(import_module(f"judge.data.{_FROM[name]}"), name)
