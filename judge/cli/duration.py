"""Durations on the command line: 30, 30s, 2m, 1h."""

from __future__ import annotations

import re

import click

from judge.errors import UsageError

_FORM = re.compile(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(ms|s|m|h)?", re.ASCII)
_SECONDS = {"ms": 0.001, "s": 1.0, "m": 60.0, "h": 3600.0}
_LONGEST = 1000 * 3600.0
_MEANT = "write 30, 30s, 2m or 1h"


def seconds_of(text: str, option: str) -> float:
    """The seconds that an option's text stands for, above 0. Raises UsageError for what is no duration."""
    found = _FORM.fullmatch(text)
    if found is None:
        raise UsageError(f"{text!r} is no duration", where=option, remedy=_MEANT)
    seconds = float(found[1]) * _SECONDS[found[2] or "s"]
    if not 0 < seconds <= _LONGEST:
        what = f"{text!r} is {'too long' if seconds else 'no time at all'}"
        raise UsageError(what, where=option, remedy=_MEANT)
    return seconds


def duration(_ctx: click.Context, option: click.Parameter, value: str) -> float:
    """An option's callback: as `seconds_of`."""
    try:
        return seconds_of(value, option.opts[0])
    except UsageError as fault:
        raise click.BadParameter(f"{fault.what}: {_MEANT}") from fault
