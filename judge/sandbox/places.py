"""Where a folder really lies: its real path, the symlinks on the way to it, other mounts that show it too.

Paths are absolute strings. A real path has no symlink in it; one folder has one real path for each mount
that shows it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from judge.errors import shortage_code

_MOUNTS = Path("/proc/self/mountinfo")
_ESCAPED = re.compile(r"\\([0-7]{3})")


class Mount(NamedTuple):
    """One line of mountinfo: `root` is the folder of the device that is seen at `point`."""

    device: str
    root: str
    point: str


def absolute(path: str) -> str:
    """The path from the root on, nothing else changed: behind a symlink, `..` is not what it looks like."""
    return path if os.path.isabs(path) else os.path.join(Path.cwd(), path)  # noqa: PTH117, PTH118 - as said


def refuse_shortage(fault: OSError) -> None:
    """Raise the fault again where it tells nothing of what is there, which would then not be hidden."""
    if shortage_code(fault):
        raise fault


def real(path: str | Path) -> str:
    """The real path, whether anything is there or not."""
    return os.path.realpath(path)


def within(path: str, folders: Iterable[str]) -> bool:
    """Whether the path is one of the folders or lies below one."""
    return any(path == folder or path.startswith(folder.rstrip("/") + "/") for folder in folders)


def outermost(paths: Iterable[str]) -> list[str]:
    """The paths that lie below no other, each once."""
    chosen = list(dict.fromkeys(paths))
    return [path for path in chosen if not within(path, [other for other in chosen if other != path])]


def links_on(path: str, leads_to: str) -> Iterator[tuple[str, str]]:
    """Every symlink on the way to something, by its own real path, with the text in it.

    `leads_to` is the real path of what is there.
    """
    if path == leads_to:
        return
    here, rest = Path("/"), list(reversed(Path(path).parts[1:]))
    while rest:
        part = rest.pop()
        step = here.parent if part == ".." else here / part
        if step.is_symlink():
            target = step.readlink()
            yield str(step), str(target)
            here = Path("/") if target.is_absolute() else here
            rest += reversed(target.parts[1:] if target.is_absolute() else target.parts)
        else:
            here = step


def mounts() -> list[Mount]:
    """What is mounted, as the kernel lists it; nothing where it lists nothing."""
    try:
        lines = _MOUNTS.read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    except OSError as fault:
        refuse_shortage(fault)
        return []
    return [_mount(line.split(" ")) for line in lines]


def elsewhere(path: str, table: Iterable[Mount]) -> Iterator[str]:
    """The other real paths of a folder, and of the parts of it that can be seen without it."""
    table = list(table)
    for inner in (path, *(mount.point for mount in table if within(mount.point, [path]))):
        for original, other in _again(inner, table):
            if not within(other, [path]) and _same(original, other):
                yield other


def _mount(fields: list[str]) -> Mount:
    root, point = (_ESCAPED.sub(lambda match: chr(int(match[1], 8)), field) for field in fields[3:5])
    return Mount(fields[2], root, point)


def _again(path: str, table: list[Mount]) -> Iterator[tuple[str, str]]:
    """Pairs of a path, this one or one below it, and where another mount shows the same."""
    own = Mount("", "/", "")
    for mount in table:  # of two at one place the later one is seen
        if within(path, [mount.point]) and len(mount.point) >= len(own.point):
            own = mount
    if not own.device:
        return
    place = _join(own.root, path[len(own.point.rstrip("/")) :])
    for mount in table:
        if mount.device != own.device:
            continue
        if within(place, [mount.root]):
            yield path, _join(mount.point, place[len(mount.root.rstrip("/")) :])
        elif within(mount.root, [place]):
            yield _join(path, mount.root[len(place.rstrip("/")) :]), mount.point


def _join(folder: str, rest: str) -> str:
    return folder.rstrip("/") + rest or "/"


def _same(one: str, other: str) -> bool:
    """Whether both are one and the same folder, neither lying under a later mount."""
    try:
        return Path(one).samefile(other)
    except OSError:
        return False
