"""What changed from one run to another: the source line by line, and what became of the test groups."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from judge.kata.history import Run

_MOST_LINES = 5_000  # of a source: beyond that no person wrote it, and comparing takes the square
_NO_END = "\\ No newline at end of file"


class Change(Struct, frozen=True):
    """From `old` to `new`. `gained` are the groups accepted only now, `lost` those accepted only before.

    A group that was left out of either run is in neither, and none is where the runs are of two problems.
    `diff` are the lines of a unified diff: none for the same source, and None for sources too long.
    """

    old: Run
    new: Run
    gained: tuple[str, ...]
    lost: tuple[str, ...]
    diff: tuple[str, ...] | None

    @property
    def same_source(self) -> bool:
        """Whether both runs judged the very same bytes."""
        return self.old.source_hash == self.new.source_hash


def change(old: Run, new: Run, sources: tuple[bytes, bytes]) -> Change:
    """What changed from `old` to `new`, which judged these sources."""
    same = old.problem == new.problem
    return Change(
        old,
        new,
        tuple(group for group in new.passed if same and group in old.failed),
        tuple(group for group in old.passed if same and group in new.failed),
        _diff(old, new, sources),
    )


def _diff(old: Run, new: Run, sources: tuple[bytes, bytes]) -> tuple[str, ...] | None:
    import difflib  # late: only who compares runs waits for it

    before, after = (_lines(source) for source in sources)
    if max(len(before), len(after)) > _MOST_LINES:
        return None
    found = difflib.unified_diff(before, after, fromfile=_named(old), tofile=_named(new), lineterm="")
    return tuple(_told(found))


def _named(run: Run) -> str:
    return f"run {run.id} {run.submission}"


def _lines(source: bytes) -> list[str]:
    """The lines of a source, each with the line feed it ends with: a last one without any differs."""
    *lines, last = source.decode("utf-8", "backslashreplace").split("\n")
    return [f"{line}\n" for line in lines] + ([last] if last else [])


def _told(diff: Iterator[str]) -> Iterator[str]:
    """The diff's lines without their line feeds; one that had none is followed by a line that says so."""
    for place, line in enumerate(diff):
        yield line.removesuffix("\n")
        if place >= 2 and line[:1] != "@" and not line.endswith("\n"):  # after the two names
            yield _NO_END
