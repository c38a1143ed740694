"""Calls as the bytes that a child reads, before its module is imported and after."""

from __future__ import annotations

import marshal
from array import array
from collections.abc import Sequence
from typing import Any

from judge.sandbox.inside import wire


def packed(entry: str, calls: Sequence[Sequence[Any]], most: int) -> tuple[bytes, bytes]:
    """The request's payload, and what is laid in its place once the module is imported: both as long.

    First the entry, how many calls there are and how many items an answer may have; then which arguments are
    arrays, and the arguments. Where no child is stopped after its import, all of it is in the payload.
    """
    places = {place for arguments in calls for place, value in enumerate(arguments) if type(value) is array}
    given = tuple(places), [_sent(arguments) if places else tuple(arguments) for arguments in calls]
    if not wire.PAUSES:
        return marshal.dumps((entry, len(calls), most, given)), b""
    head, arguments = marshal.dumps((entry, len(calls), most, None)), marshal.dumps(given)
    size = max(len(head), len(arguments))
    return head.ljust(size, b"\0"), arguments.ljust(size, b"\0")


def _sent(arguments: Sequence[Any]) -> tuple[Any, ...]:
    """The arguments, an array as its code and what marshal writes as its bytes."""
    return tuple([(each.typecode, each) if type(each) is array else each for each in arguments])
