"""What becomes of a command's value: JSON on standard output, or its view on the screen.

A command returns a frozen Struct, or an iterator of them where the work is long; it never prints. A value
may have `exit_code`, `published` (what goes out as JSON instead of it: a tuple of structs, one a line),
`plain` (text for another program, such as CSV, which is written as it is), `line` (all that is shown, where
that is one line) and `paged` (whether the pager shows what is longer than the terminal).
"""

from __future__ import annotations

import sys
from collections.abc import Generator, Iterable
from contextlib import suppress
from typing import TYPE_CHECKING

import msgspec
from msgspec import Struct

from judge.errors import ExitCode

if TYPE_CHECKING:
    from judge.cli.options import Common


def emit(found: Struct | Iterable[Struct], common: Common) -> ExitCode:
    """Write each value as soon as it is there; the greatest `exit_code` of them all.

    Ctrl-C between two values goes to who makes them, who may have something to say before it ends.
    """
    values = iter((found,) if isinstance(found, Struct) else found)
    worst = ExitCode.ACCEPTED
    try:
        for value in values:
            worst = max(worst, _written(value, common))
    except KeyboardInterrupt as pressed:
        if isinstance(values, Generator):
            with suppress(StopIteration):
                _written(values.throw(pressed), common)
        raise
    return worst


def _written(value: Struct, common: Common) -> ExitCode:
    """Write the value; its exit code."""
    if common.json:
        for each in getattr(value, "published", (value,)):
            sys.stdout.write(_json(each) + "\n")
        sys.stdout.flush()
    elif plain := getattr(value, "plain", ""):
        sys.stdout.write(plain)
        sys.stdout.flush()
    else:
        from judge.report.screen import out, show  # --json does without the screen

        screen = out()
        line = "" if screen.colour or screen.width else getattr(value, "line", "")
        if line and line.isprintable():
            screen.write(f"{line}\n")
        else:
            from judge.report.views import view

            show(view(value, screen), screen, paged=getattr(value, "paged", False))
    return getattr(value, "exit_code", ExitCode.ACCEPTED)


def _json(value: Struct) -> str:
    """The value on one line; paths, types and exact numbers are text."""
    try:
        text = msgspec.json.encode(value, enc_hook=str).decode()
        text.encode(getattr(sys.stdout, "encoding", None) or "utf-8")
    except UnicodeEncodeError:  # half of a surrogate pair in a file's name, or a stream of few letters
        import json

        return json.dumps(msgspec.to_builtins(value, enc_hook=str))
    return text
