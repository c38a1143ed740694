"""The living processes below one, as /proc tells."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Process(NamedTuple):
    name: str
    parent: int
    birth: int  # in ticks: tells it from a later one of the same number


def living() -> dict[int, Process]:
    """All that have not ended, whoever waits for them."""
    found = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                name, _, rest = (entry / "stat").read_text().rpartition(")")
            except OSError:
                continue
            fields = rest.split()
            if fields[0] not in "ZX":
                found[int(entry.name)] = Process(name.partition("(")[2], int(fields[1]), int(fields[19]))
    return found


def below(pid: int) -> dict[int, Process]:
    """The descendants of a process."""
    processes, found, grown = living(), {pid}, True
    while grown:
        more = {child for child, process in processes.items() if process.parent in found} - found
        found |= more
        grown = bool(more)
    return {child: processes[child] for child in sorted(found - {pid})}


def left(family: dict[int, Process]) -> list[int]:
    """Which of them live still."""
    now = living()
    return [pid for pid, process in family.items() if pid in now and now[pid].birth == process.birth]
