"""Durations on the command line: 30, 30s, 2m, 1h."""

from __future__ import annotations

import re

import click

_FORM = re.compile(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(ms|s|m|h)?", re.ASCII)
_SECONDS = {"ms": 0.001, "s": 1.0, "m": 60.0, "h": 3600.0}
_LONGEST = 1000 * 3600.0
_MEANT = "write 30, 30s, 2m or 1h"


def duration(_ctx: click.Context, _option: click.Parameter, value: str) -> float:
    """An option's callback: the seconds, above 0; what is no duration is refused in one line."""
    found = _FORM.fullmatch(value)
    if found is None:
        raise click.BadParameter(f"{value!r} is no duration: {_MEANT}")
    seconds = float(found[1]) * _SECONDS[found[2] or "s"]
    if not 0 < seconds <= _LONGEST:
        raise click.BadParameter(f"{value!r} is {'too long' if seconds else 'no time at all'}: {_MEANT}")
    return seconds
