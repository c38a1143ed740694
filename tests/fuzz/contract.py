"""What holds of every command line, however odd it is: the faults of one that has ended."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from jsonschema import Draft202012Validator
from runs import Ended, Run
from worker import CLOSED, FULL, KEPT

from judge.cli.app import app
from judge.schema import schema_of

STATUSES = (0, 1, 2, 3, 130, 141)
_LINES = 100  # that any command line says on standard error
_LONGEST = 2_000  # characters of one of them
_USAGE = 3  # lines that a usage error takes
_MAY_BE_EMPTY = ("help", "history", "list")  # commands that write an object for each thing there is
_TALK = ("quiz", "interview")  # commands that ask on standard error where standard output is JSON
_ASKED = "[y/N]: "  # where a question ends that a person was asked
_NEVER = ("Traceback (most recent call last)", "internal fault", "\x1b[31mred", "\x1b]0;title")


def faults(run: Run, ended: Ended) -> list[str]:
    """What is wrong with how the command line ended, a sentence each."""
    found = [
        f"it changes a file that is not its own: {what}" for what in ended.outside if _foreign(run, what)
    ]
    found += [f"it leaves a process behind: {what[:200]}" for what in ended.left]
    if ended.status == -14:
        found.append("it does not end")
    elif ended.status not in STATUSES and not (run.interrupt is not None and ended.status == -2):
        found.append(f"its status {ended.status} is not in the contract")
    if "--debug" in run.words:  # it shows the traceback that is asked for
        ended = Ended(ended.status, ended.out, "judge: …\n", "", ())
    for text in _NEVER:
        found += [f"{name} says {text!r}" for name in ("out", "err", "shown") if text in getattr(ended, name)]
    if run.streams[1] in (CLOSED, FULL) and ended.status == 0:
        found.append("it ends with status 0 though nobody got its output")
    if run.streams[2] == KEPT:
        found += _in_complaints(run, ended)
    if run.checked and run.streams[1] == KEPT:
        found += _in_json(run, ended)
    elif run.streams[1] == KEPT:
        found += _in_text("standard output", ended.out)
    return found


def _foreign(run: Run, change: str) -> bool:
    """Whether nobody asked for that change: of a path that was named, of pins, of a temporary folder."""
    if "--pin" in run.words and "pins.json" in change:
        return False
    if "TMPDIR" in run.settings and change.startswith("open "):
        return False
    named = [text.rpartition("=")[2] for text in (*run.words, *filter(None, run.settings.values()))]
    asked = [Path(text).parts[:2] for text in named if text.startswith("/")]
    return tuple(Path(change.partition(" ")[2].strip("'")).parts[:2]) not in asked or "/dev/" in change


def _in_complaints(run: Run, ended: Ended) -> list[str]:
    """What is wrong with standard error."""
    lines = ended.err.rpartition(_ASKED)[2].splitlines()
    if run.interrupt is not None and lines[-1:] == [""]:  # for the ^C that a terminal shows
        lines.pop()
    talks = run.checked and run.words[0] in _TALK and ended.status in (0, 141)  # nobody reads the JSON
    foreign = [line for line in lines if not line.startswith("judge: ") and not talks]
    found = [f"a line of standard error is not the judge's: {line[:200]!r}" for line in foreign[:1]]
    found += [
        f"a line of standard error has {len(line)} characters" for line in lines if len(line) > _LONGEST
    ]
    if len(lines) > (_USAGE if ended.status == 2 else _LINES):
        found.append(f"it says {len(lines)} lines on standard error with status {ended.status}")
    if ended.status == 2 and not lines:
        found.append("it ends with status 2 and does not say why")
    if ended.status == 3 and not lines and not ended.out and run.streams[1] == KEPT:
        found.append("it ends with status 3 and does not say why")
    return [*found, *_in_text("standard error", ended.err)]


def _in_text(where: str, text: str) -> list[str]:
    """No character may steer the terminal that the text is shown on."""
    odd = {character for character in text if character not in "\n\t" and not character.isprintable()}
    return [f"{where} holds {', '.join(sorted(map(repr, odd)))}"] if odd else []


def _in_json(run: Run, ended: Ended) -> list[str]:
    """What is wrong with standard output, which is to hold objects of the command's schema."""
    found = []
    if ended.out and not ended.out.endswith("\n"):
        found.append("the last line of its JSON has no end")
    if ended.status in (0, 1) and not ended.out and run.words[0] not in _MAY_BE_EMPTY:
        found.append(f"it ends with status {ended.status} and writes no JSON")
    for line in ended.out.split("\n")[:-1]:
        try:
            value = json.loads(line, parse_constant=_no_constant)
        except (ValueError, RecursionError) as fault:
            found.append(f"this is no JSON ({fault}): {line[:200]!r}")
            continue
        if run.words[0] == "help" and "$schema" in value:  # the schema of a command
            continue
        error = next(_validator(run.words[0]).iter_errors(value), None)
        if error is not None:
            place = "/".join(map(str, error.absolute_path))
            found.append(f"its JSON breaks the schema at {place or 'the top'}: {error.message[:300]}")
    return found


def _no_constant(name: str) -> Any:
    raise ValueError(f"{name} is no number of JSON")


@cache
def _validator(command: str) -> Draft202012Validator:
    made = app.get_command(None, command)
    assert made is not None
    return Draft202012Validator(schema_of(made))
