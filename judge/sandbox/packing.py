"""Series of calls as the bytes that a child reads.

The same cases go to every submission that is judged, and again in every turn of a race: what was packed last
is kept. Nobody may change a series that was ever packed.
"""

from __future__ import annotations

import marshal
from array import array
from collections import OrderedDict
from collections.abc import Sequence
from threading import Lock
from typing import Any

Series = Sequence[Sequence[Any]]  # the argument lists of some calls

MOST_KEPT = 8  # batches of series
LARGEST_KEPT = 4 << 20  # bytes of a batch


class _Kept:
    """The batches that were packed last. Each is known by the very objects it was packed from."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._batches: OrderedDict[tuple[Any, ...], tuple[Sequence[Series], list[bytes]]] = OrderedDict()

    def __call__(self, entry: str, series: Sequence[Series], most: int) -> list[bytes]:
        key = (entry, most, *map(id, series))
        with self._lock:
            found = self._batches.get(key)
            if found is not None:
                self._batches.move_to_end(key)
                return found[1]
        batch = _packed(entry, series, most)
        if sum(map(len, batch)) <= LARGEST_KEPT:
            with self._lock:
                self._batches[key] = tuple(series), batch  # kept alive, so that no id is given again
                if len(self._batches) > MOST_KEPT:
                    self._batches.popitem(last=False)
        return batch


packed = _Kept()
"""What the child needs for each series.

The entry, how many calls there are in all, how many items an answer may have, which arguments are arrays, and
the arguments.
"""


def _packed(entry: str, series: Sequence[Series], most: int) -> list[bytes]:
    count = sum(len(calls) for calls in series)
    places = {
        place
        for calls in series
        for arguments in calls
        for place, value in enumerate(arguments)
        if type(value) is array
    }
    carried = _sent if places else tuple
    return [
        marshal.dumps((entry, count, most, tuple(places), [carried(arguments) for arguments in calls]))
        for calls in series
    ]


def _sent(arguments: Sequence[Any]) -> tuple[Any, ...]:
    """The arguments, an array as its code and what marshal writes as its bytes."""
    return tuple([(each.typecode, each) if type(each) is array else each for each in arguments])
