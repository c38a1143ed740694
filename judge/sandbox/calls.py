"""Calls as a process reads them: as bytes in Python, as text in another language, whose replies are text too.

    the input      cases, and 1 where each answer is to be written at once, else 0; then a line for each call,
                   tokens: a number, `true` or `false`, the items of a tuple; of a list its length first, and
                   of a dict, whose keys and values follow in the order of the keys;
                   `none` for what is not there; a word or a text, which is `=` and hexadecimal where it
                   has other signs than a word's
    the output     a line of JSON for each call, [0, answer] or [1, "what was raised"]

Calls in a row on an object are a list as any other, of tuples: a method's name and its arguments. Their
answer is a list too; what was raised ends in `, in call 3` then.

Replies are foreign data: bounded, parsed as JSON, never believed.
"""

from __future__ import annotations

import marshal
import re
from array import array
from collections.abc import Sequence
from typing import Any

from judge.sandbox import outcome
from judge.sandbox.boundary import Reply
from judge.sandbox.encode import encode, in_call
from judge.sandbox.inside import wire

_NUMBERS = {int, float}
_SMALL = 1 << 63
_CALL = re.compile(r", in call (\d{1,9})\Z")
_WORD = re.compile(r"(?!none\Z)[\w-]+", re.ASCII)


def packed(entry: str, calls: Sequence[Sequence[Any]], most: int) -> tuple[bytes, bytes]:
    """The request's payload, and what is laid in its place once the module is imported: both as long.

    First the entry, how many calls there are and how many items an answer may have; then which arguments are
    arrays, and the arguments, an array as its code and what marshal writes as its bytes. Where no child is
    stopped after its import, all of it is in the payload.
    """
    places = {place for arguments in calls for place, value in enumerate(arguments) if type(value) is array}
    rows = [tuple(arguments) for arguments in calls]
    if places:
        rows = [tuple([(v.typecode, v) if type(v) is array else v for v in row]) for row in rows]
    given = tuple(places), rows
    if not wire.PAUSES:
        return marshal.dumps((entry, len(calls), most, given)), b""
    head, arguments = marshal.dumps((entry, len(calls), most, None)), marshal.dumps(given)
    size = max(len(head), len(arguments))
    return head.ljust(size, b"\0"), arguments.ljust(size, b"\0")


def text(series: Sequence[Sequence[Any]], *, at_once: bool = False) -> bytes:
    """The standard input of a driver that is to make these calls."""
    lines = [f"{len(series)} {int(at_once)}"]
    lines += [" ".join(map(_words, arguments)) for arguments in series]
    return ("\n".join(lines) + "\n").encode("ascii")


def _words(value: Any) -> str:
    """The tokens of a value, a space between two of them."""
    if isinstance(value, list | array):  # it may be of a million numbers
        each = repr if set(map(type, value)) <= _NUMBERS else _words
        return " ".join([str(len(value)), *map(each, value)])
    if isinstance(value, tuple):
        return " ".join(map(_words, value))
    if isinstance(value, dict):
        return " ".join([str(len(value)), *map(_words, sorted(value.items(), key=lambda entry: entry[0]))])
    if value is None:
        return "none"
    if isinstance(value, str):
        return value if _WORD.fullmatch(value) else f"={value.encode().hex()}"
    return repr(value).lower()  # of a bool in small letters


def parted(detail: str, case: Sequence[Any]) -> tuple[str, str]:
    """What was raised, and in which call of a case: `, in call 3: get(1)`, or nothing."""
    found = _CALL.search(detail)
    row = case[-1] if case and isinstance(case[-1], list) else ()
    if not found or not 0 < int(found[1]) <= len(row):
        return detail, ""
    return detail[: found.start()], in_call(int(found[1]), *row[int(found[1]) - 1])


def replies(stdout: bytes, most: int) -> tuple[list[Reply], bool]:
    """The replies that were written, and whether they kept to the form; what is unfinished is none."""
    whole = stdout[: stdout.rfind(b"\n") + 1]
    found, kept_form = outcome.parse_replies(whole.replace(b"\n", b",\n"), most)
    return [reply._replace(answer=_sent(reply.answer)) for reply in found], kept_form


def _sent(answer: Any) -> Any:
    """An answer in the form of encode.py: an int of many digits, and a text, are marked there."""
    kind = type(answer)
    if kind is int and not -_SMALL <= answer < _SMALL:
        return {"int": f"{answer:x}"}
    if kind is str:
        return encode(answer)
    if kind is dict and type(answer.get("dict")) is list:
        return {"dict": [_sent(entry) for entry in answer["dict"]]}
    if kind is list:
        kinds = set(map(type, answer))
        if kinds == {float} or (kinds == {int} and min(answer) >= -_SMALL and max(answer) < _SMALL):
            return answer
        return [_sent(item) for item in answer]
    return answer
