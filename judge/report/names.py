"""Names of files as they are shown: nothing in one is taken for an option, a command or the next line."""

from __future__ import annotations

import os
import shlex

from judge.report.layout import printable


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
