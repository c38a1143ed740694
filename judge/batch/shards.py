"""A class in parts that know nothing of each other, on machines with no more than the folder in common.

Equal texts to one problem meet in one shard, so that each is judged once as in a plain run. The shards' files
are put together by their rows' keys.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from msgspec import Struct

from judge.batch.model import KeptRow, Submission
from judge.batch.store import ResultStore
from judge.cache import digest
from judge.errors import UsageError
from judge.report.words import counted

_FORM = re.compile(r"([0-9]{1,6})/([0-9]{1,6})", re.ASCII)


class Shard(Struct, frozen=True):
    """The part `number`, from 1, of `count`."""

    number: int
    count: int

    @classmethod
    def read(cls, text: str) -> Shard:
        """`3/20` as a shard. Raises UsageError."""
        found = _FORM.fullmatch(text)
        number, count = map(int, found.groups()) if found else (0, 0)
        if not 1 <= number <= count:
            remedy = "write 3/20 for the third of 20, from 1/20 to 20/20"
            raise UsageError(f"{text!r} is not a part", remedy=remedy)
        return cls(number, count)

    def holds(self, each: Submission) -> bool:
        """Whether a submission is of this part."""
        own = each.file if each.why else each.digest
        return int(digest(f"{each.problem}/{own}".encode())[:15], 16) % self.count == self.number - 1

    def beside(self, place: Path) -> Path:
        """Where its results are, if those of the whole class are at `place`."""
        return place.with_name(f"{place.stem}.{self.number}-of-{self.count}{place.suffix}")


def merged(store: ResultStore, parts: Sequence[Path]) -> str:
    """Take the rows of other files over; what is to be said of them.

    Raises:
        StoreError: one is no such file, or cannot be read; then nothing is taken over.
    """
    found: list[KeptRow] = []
    for path in parts:
        with ResultStore.read(path) as part:
            found += part.every()
    rows = {row.key: row for row in sorted(found, key=lambda row: row.at)}.values()
    store.keep_all(rows)
    return f"{len(rows)} rows merged from {counted(len(parts), 'file')}"
