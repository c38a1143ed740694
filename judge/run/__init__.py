"""Judging one submission: running it on cases, comparing, measuring.

    runner.py        one interface for both ways to run it; function.py, program.py: the two
    replies.py       what comes back
    group.py         a test group while it is judged; groups.py runs several in as few processes as it takes
    execute.py       all groups, and what they come to; settings.py: how; budget.py: at what cost at most
    reference.py, measure.py, timing.py
                     the race against the reference solution, and what its turns say
    result.py        what all of it came to; tried.py: a person's own case, and what was said of it
    stress.py        fresh cases without end
    alone.py         measuring alone on the whole machine

The names below are imported when they are asked for.
"""

from __future__ import annotations

from typing import Any

_FROM = {
    "Failure": "result",
    "GroupResult": "result",
    "Reference": "reference",
    "Result": "result",
    "Settings": "settings",
    "judge_submission": "execute",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in _FROM:
        raise AttributeError(f"module 'judge.run' has no attribute {name!r}")
    return getattr(import_module(f"judge.run.{_FROM[name]}"), name)
