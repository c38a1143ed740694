"""Differences between what was kept and what is, said by meaning: `count/x.py: names a → b`."""

from __future__ import annotations

import difflib
import json
from collections.abc import Iterator, Mapping
from typing import Any

_SHORT = 160  # characters of a value in a difference


def differences(kept: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    """A line for each thing that is not as it was kept, by key and field."""
    for key in sorted(kept.keys() | now.keys()):
        if key not in now:
            yield f"{key}: gone"
        elif key not in kept:
            yield f"{key}: new"
        else:
            yield from (f"{key}: {each}" for each in _fields("", kept[key], now[key]))


def _fields(place: str, kept: Any, now: Any) -> Iterator[str]:
    if kept == now:
        return
    if isinstance(kept, Mapping) and isinstance(now, Mapping):
        for name in [*kept, *(name for name in now if name not in kept)]:
            yield from _fields(f"{place} {name}".strip(), kept.get(name), now.get(name))
    elif isinstance(kept, str) and isinstance(now, str) and "\n" in kept:
        yield "\n" + "\n".join(
            difflib.unified_diff(kept.splitlines(), now.splitlines(), "kept", "now", "", "", 1)
        )
    else:
        yield f"{place} {_words(kept)} → {_words(now)}"


def _words(value: Any) -> str:
    text = (
        "none"
        if value is None
        else value
        if isinstance(value, str)
        else json.dumps(value, ensure_ascii=False)
    )
    return text if len(text) <= _SHORT else f"{text[:_SHORT]}…"
