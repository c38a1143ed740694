"""Whose a file is in what a learning platform hands out: the forms of its names, and who of a list is meant.

Moodle            Ada Lovelace_4711_assignsubmission_file/count.py, or …_file_count.py
Canvas            lovelaceada_LATE_101_555_count.py, anon_x7Kp2_555_count.py
Brightspace       9001-42 - Ada Lovelace - Nov 20, 2026 612 PM/count.py
Blackboard        HW 1_alove_attempt_2026-11-20-10-15-00_count.py
Gradescope        submission_77/count.py, whose submission_metadata.yml tells the students

A form counts where nearly all names beside it have it: else it is chance. The forms of Moodle and Canvas were
read in their sources, the others in their documentation and in readers of their files.
"""

from __future__ import annotations

import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from datetime import datetime
from itertools import pairwise
from pathlib import PurePath

from msgspec import Struct

from judge.batch.gradebook import Sheet
from judge.report.published_klass import Student

METADATA = "submission_metadata.yml"
_FORMS = (
    re.compile(r"(?P<name>.*)_(?P<key>\d+)_assign(?:submission|feedback)_[a-z]+(?:_|$)(?P<file>.*)"),
    re.compile(r"(?P<late>LATE_)?anon_(?P<key>[^_]+)_\d+_(?P<file>.+)"),
    re.compile(r"(?P<name>.*?)(?P<late>_LATE)?_(?P<key>\d+)_(?:\d+_|(?=(?:text|link)\.html$))(?P<file>.+)"),
    re.compile(r"\d+-\d+ - (?P<name>.+?) - (?P<at>[^-]*\b\d{4}\b[^-]*?)(?: - (?P<file>.+))?"),
    re.compile(r"(?P<name>.+)_[^_\d]+_(?P<at>\d{4}(?:-\d\d){5})(?:_(?P<file>.+)|\.txt)"),
)
# Columns of no one, or of others.
_SHARED = {"group", "groups", "section", "sections", "status", "note", "extra days"}
_SHARED |= {"team", "teams", "partner", "partners"}
_MOST = 0.8  # of the names beside each other have the form
_LEAST = 3  # letters of a cell that may be a part of a name
_AGAIN = re.compile(r"-\d+(?=\.[^.]+$)")  # of a second upload: count-1.py
# Of Gradescope's metadata, which no strict reader of YAML takes: a folder, who submitted it, one of them.
_FOLDER = re.compile(r"^(submission_\d+):\s*$", re.MULTILINE)
_SUBMITTERS = re.compile(r"^( *):submitters:\s*$(.*?)(?=^\1:|\Z)", re.MULTILINE | re.DOTALL)
_SUBMITTER = re.compile(r"^ *- ", re.MULTILINE)
_CREATED = re.compile(r"^ {1,2}:created_at:\s*['\"]?([^'\"\n]+)", re.MULTILINE)
_TIMES = ("%Y-%m-%d-%H-%M-%S", "%Y-%m-%d %H:%M:%S %z", "%b %d, %Y %I%M %p", "%d %b %Y %I%M %p")
_KEY = re.compile(r"^ *:(\w+):\s*['\"]?(.*?)['\"]?\s*$", re.MULTILINE)


class Owner(Struct, frozen=True):
    """Whose a name is: the number or user name in it, the person's and the file's own name, if it is late,
    and the second of the epoch when it was submitted, 0 where the platform does not say.
    """

    key: str
    name: str
    file: str = ""
    late: bool = False
    at: float = 0.0

    @classmethod
    def read(cls, parts: Mapping[str, str]) -> Owner:
        """What the parts of a form tell."""
        key, name, late, at = (parts.get(part, "") for part in ("key", "name", "late", "at"))
        return cls(key, name, _AGAIN.sub("", parts.get("file", "")), bool(late), _second(at))

    def called(self, people: int) -> str:
        """What the person is called, where so many have the name."""
        return f"{self.name} ({self.key})" if self.name and people > 1 else self.name or self.key


def owners(names: Iterable[str]) -> dict[str, list[Owner]]:
    """Of names beside each other those that have the form of nearly all of them, each with its owner."""
    every = [name for name in names if not name.startswith("index.")]
    for form in _FORMS:
        found = {name: [Owner.read(match.groupdict(""))] for name in every if (match := form.fullmatch(name))}
        if found and len(found) >= _MOST * len(every):
            return found
    return {}


def own_name(file: str) -> str:
    """What a file is called by its student, without what a platform writes before it."""
    name = PurePath(file).name
    found = [match["file"] for form in _FORMS if (match := form.fullmatch(name))]
    return found[0] or "attempt.txt" if found else name


def _second(said: str) -> float:
    """The second of the epoch, by this machine's clock where no zone is said; 0 where it cannot be read."""
    said = re.sub(r"(?<=[^\W\d_]{3})[^\W\d_]+|\.\d+", "", said.strip())  # of a month, of a second
    for form in _TIMES:
        with suppress(ValueError):
            return datetime.strptime(re.sub(r"\b(?=\d{3} )", "0", said), form).timestamp()
    return 0.0


def submitters(metadata: str) -> dict[str, list[Owner]]:
    """Who submitted each folder of a Gradescope export, several if it is a group's."""
    _, *sections = _FOLDER.split(metadata)
    found = {}
    for folder, section in zip(sections[::2], sections[1::2], strict=True):
        listed = _SUBMITTERS.search(section)
        members = [dict(_KEY.findall(each)) for each in _SUBMITTER.split(listed[2])[1:]] if listed else []
        created = _CREATED.search(section)
        at = _second(created[1]) if created else 0.0
        found[folder] = [
            Owner(each.get("email") or each.get("sid", ""), each.get("name", ""), at=at) for each in members
        ]
    return found


class Roster:
    """Who of a list is meant by a name; `titles` are its own, `sheet` is how it is written, `unclear`
    says which names fit several.
    """

    def __init__(
        self, students: Sequence[Student] = (), titles: Sequence[str] = (), sheet: Sheet | None = None
    ) -> None:
        self.students, self.titles, self.sheet = tuple(students), tuple(titles), sheet or Sheet()
        self._cells: defaultdict[str, set[str]] = defaultdict(set)
        self._names: defaultdict[str, set[str]] = defaultdict(set)
        self._ids = {each.id for each in students}
        self.unclear: dict[str, str] = {}
        tried = [at for at, title in enumerate(titles) if title.casefold() not in _SHARED]
        for each in students:
            cells = [each.cells[at].strip().removeprefix("#") for at in tried if at < len(each.cells)]
            for cell in filter(None, (each.id, *cells)):
                self._cells[cell.casefold()].add(each.id)
            for name in _names([each.name, *cells]):
                self._names[name].add(each.id)

    def owner(self, owner: Owner) -> str:
        """The id of who fits best: by the key as a cell, or the end of one, then by name or mail; empty where
        several do.
        """
        key = owner.key.casefold()
        return self._only(
            owner.name,
            self._cells.get(key),
            self._ending(key),
            *map(self._names.get, _plain(owner.name)),
            self._within(owner.name),
        )

    def named(self, name: str) -> str:
        """The id of whom a folder or a file is called after; empty where that is nobody or several."""
        if name in self._ids:
            return name
        return self._only(name, self._cells.get(name.casefold()), *map(self._names.get, _plain(name)))

    def _only(self, name: str, *groups: set[str] | None) -> str:
        """Who is alone in the first group that is not empty; empty where there are several."""
        first = next(filter(None, groups), set())
        if len(first) > 1:
            who = " and ".join(sorted(first))
            self.unclear[name] = f"{name!r} fits {who}: write this name into a column 'id' of the list"
        return next(iter(first)) if len(first) == 1 else ""

    def _ending(self, key: str) -> set[str]:
        """Who has a cell such as `Participant 4711`, or a mail address that begins so."""
        end = rf"[^\d@]+{re.escape(key)}|" if key.isdecimal() else ""
        fits = re.compile(rf"{end}{re.escape(key)}@.*", re.DOTALL)
        return {who for cell, ids in self._cells.items() if key and fits.fullmatch(cell) for who in ids}

    def _within(self, name: str) -> set[str]:
        """Who has the longest cell that is the first or the last part of the name."""
        folded = name.casefold()
        parts = (
            cell
            for cell in self._cells
            if len(cell) >= _LEAST and re.search(rf"(?:^|[_-]){re.escape(cell)}$|^{re.escape(cell)} ", folded)
        )
        return self._cells.get(max(parts, key=len, default=""), set())


def _names(cells: Iterable[str]) -> Iterator[str]:
    """What a student may be called in letters and digits alone: each cell, two beside each other, a mail."""
    cells = [*filter(None, cells)]
    for cell in cells:
        last, comma, first = cell.partition(",")
        yield from _plain(cell.partition("@")[0])
        yield from _plain(first + last) if comma else ()
    for one, other in pairwise(cells):
        yield from (*_plain(one + other), *_plain(other + one))


def _plain(name: str) -> list[str]:
    """Letters and digits alone, of any language, and those without marks as Canvas writes them."""
    folded = unicodedata.normalize("NFC", name).casefold()
    found = ["".join(filter(str.isalnum, folded)), re.sub("[^a-z0-9]", "", folded)]
    return [each for each in dict.fromkeys(found) if each]
