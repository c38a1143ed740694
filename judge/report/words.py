"""Words for a person: numbers, arguments, durations, names of files; nothing in them steers a terminal."""

from __future__ import annotations

import os
import shlex
from collections.abc import Mapping
from datetime import date, datetime
from typing import Any

from judge.errors import printable as printable
from judge.values.types import Entries
from judge.values.wire import brief

_ITEMS = 40  # of a list that are shown
_LETTERS = 400  # of a text


def arguments(values: Mapping[str, Any]) -> str:
    """The arguments of a call by name, `cx=0, A=(3, 4)`; numbers in full, as `repr` writes them."""
    return ", ".join(f"{name}={argument(value)}" for name, value in values.items())


def argument(value: Any) -> str:
    """One argument as Python writes it, its lists and texts cut where they are long."""
    if isinstance(value, list):
        parts = [argument(part) for part in value[:_ITEMS]]
        more = f", …] ({len(value):,} items)" if len(value) > _ITEMS else "]"
        return f"[{', '.join(parts)}{more}"
    if isinstance(value, Entries):
        entries = [f"{argument(key)}: {argument(each)}" for key, each in value[:_ITEMS]]
        more = f", …}} ({len(value):,} entries)" if len(value) > _ITEMS else "}"
        return f"{{{', '.join(entries)}{more}"
    if isinstance(value, tuple):
        return f"({', '.join(argument(part) for part in value)})"
    return brief(value, _LETTERS) if isinstance(value, str) else repr(value)


def counted(number: int, noun: str) -> str:
    """`1 case`, `1,240 cases`."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def seconds(duration: float) -> str:
    """A duration in the unit that suits it."""
    if duration < 0.0095:
        return f"{duration * 1e3:.1f} ms"
    return f"{duration * 1e3:.0f} ms" if duration < 0.9995 else f"{duration:.2f} s"


def moment(when: datetime) -> str:
    """A time as the clock on the wall shows it."""
    return when.astimezone().strftime("%Y-%m-%d %H:%M")


def day(when: datetime | date | None) -> str:
    """A day as the calendar on the wall shows it; nothing for None."""
    here = when.astimezone() if isinstance(when, datetime) else when
    return here.strftime("%Y-%m-%d") if here else ""


def due_words(due: datetime, now: datetime) -> str:
    """When it is due, in days from now: `in 3 days`, `today`, `1 day ago`."""
    days = (due.astimezone(now.tzinfo).date() - now.date()).days
    count = counted(abs(days), "day")
    return "today" if days == 0 else f"{count} ago" if days < 0 else f"in {count}"


def times(factor: float) -> str:
    """A multiple with as many digits as it deserves: `0.97`, `1.3`, `12`, `1,117`."""
    return f"{factor:,.0f}" if factor >= 9.95 else f"{factor:.1f}" if factor >= 0.995 else f"{factor:.2f}"


def shown_name(name: str) -> str:
    r"""The name of a file on one line, begun by `./` unless by a letter, a digit, `_`, `.` or `/`.

    `-x.py` would be an option where somebody copies it, and `::error::x.py` at the start of a line is a
    command to GitHub. A line break in a name is written out, `\n`, as are all control characters.
    """
    return printable(_anchored(name))


def shown_command(*words: str, file: str) -> str:
    """A command on one line that a shell takes as it stands; `file` is its last word."""
    return f"{shlex.join(words)} {_word(_anchored(file))}"


def _anchored(name: str) -> str:
    return name if name[:1].isalnum() or name[:1] in ("_", ".", "/", "") else f"./{name}"


def _word(name: str) -> str:
    r"""A name as one word of a shell; what cannot be printed as bash, zsh and ksh read it: `$'a\x0ab.py'`."""
    if name.isprintable() and "##[" not in name:  # of which the screen writes a part out
        return shlex.quote(name)
    parts = (
        chr(byte) if 32 <= byte < 127 and byte not in b"'\\#" else f"\\x{byte:02x}"
        for byte in os.fsencode(name)
    )
    return f"$'{''.join(parts)}'"
