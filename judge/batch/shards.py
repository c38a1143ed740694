"""A class in parts that know nothing of each other, on machines with no more than the folder in common.

Equal texts to one problem meet in one shard, so that each is judged once as in a plain run. The shards' files
are put together by their rows' keys.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from msgspec import Struct

from judge.batch.model import Handin, Row, Standard
from judge.batch.standard import differing
from judge.batch.store import STORE, Store
from judge.cache import digest
from judge.errors import StoreError, UsageError
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
        number, count = (int(part) for part in found.groups()) if found else (0, 0)
        if not 1 <= number <= count:
            remedy = "write 3/20 for the third of 20, from 1/20 to 20/20"
            raise UsageError(f"{text!r} is not a part", remedy=remedy)
        return cls(number, count)

    def holds(self, handin: Handin) -> bool:
        """Whether a hand-in is of this part."""
        own = handin.file if handin.why else handin.digest
        return int(digest(f"{handin.problem}/{own}".encode())[:15], 16) % self.count == self.number - 1

    def beside(self, place: Path) -> Path:
        """Where its results are, if those of the whole class are at `place`."""
        return place.with_name(f"{place.stem}.{self.number}-of-{self.count}{place.suffix}")


def merged(store: Store, parts: Sequence[Path]) -> list[str]:
    """Take the rows of other files over; what is to be said of them.

    Raises:
        StoreError: one is no such file, or cannot be read; then nothing is taken over.
    """
    rows: dict[str, Row] = {}
    for path in parts:
        if path.absolute() == store.path.absolute():
            raise UsageError("a file cannot be merged into itself", where=str(path))
        for row in _rows_of(path):
            old = rows.setdefault(row.key, row)
            if old.at < row.at:
                rows[row.key] = row
    store.keep_all(rows.values())
    return [f"{len(rows)} rows merged from {counted(len(parts), 'file')}", *_apart(rows.values())]


def _rows_of(path: Path) -> list[Row]:
    try:
        with Store.read(path) as part:
            return part.every()
    except StoreError as fault:
        if fault.remedy in (None, STORE.elsewhere):
            fault.remedy = "name the files that 'judge class --shard' wrote"
        raise


def _apart(rows: Iterable[Row]) -> list[str]:
    """In what the standards of rows differ that are now in one file; the data of two problems always do."""
    first: dict[str, Standard] = {}
    said = Counter[str]()
    for row in sorted(rows, key=lambda row: (row.problem, row.at)):
        if row.standard is not None:
            said[differing(first.setdefault(row.problem, row.standard), row.standard)] += 1
    return [
        f"the rows were not judged alike: {parts} in {count} of them"
        for parts, count in said.items()
        if parts
    ]
