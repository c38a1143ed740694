"""Where a folder really lies: its real path, the symlinks on the way to it, other mounts that show it too.

Paths are absolute strings. A real path has no symlink in it; one folder has one real path for each mount
that shows it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
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


def listed(folder: str) -> list[str]:
    """The names in a folder; none where nobody lets us look. Raises OSError for a shortage."""
    try:
        return os.listdir(folder)  # noqa: PTH208
    except OSError as fault:
        refuse_shortage(fault)
        return []


def real(path: str | Path) -> str:
    """The real path, whether anything is there or not."""
    return os.path.realpath(path)


def within(path: str, folders: Iterable[str]) -> bool:
    """Whether the path is one of the folders or lies below one."""
    return f"{path}/".startswith(tuple(f"{folder.rstrip('/')}/" for folder in folders))


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
    for step in (*reversed(Path(path).parents), Path(path)):
        here = Path(real(str(step.parent)), step.name)
        if here.is_symlink():
            target = here.readlink()
            yield str(here), str(target)
            yield from links_on(str(here.parent / target), leads_to)


def mounts() -> list[Mount]:
    """What is mounted, as the kernel lists it; nothing where it lists nothing."""
    try:
        lines = _MOUNTS.read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    except OSError as fault:
        refuse_shortage(fault)
        return []
    fields = [[_plain(field) for field in line.split(" ")] for line in lines]
    return [Mount(device, root, point) for _, _, device, root, point, *_ in fields]


def elsewhere(path: str, table: Sequence[Mount]) -> Iterator[str]:
    """The real paths of a folder in other mounts, and of the parts of it that can be seen without it."""
    inner = [(mount.device, mount.root) for mount in table if within(mount.point, [path])]
    for device, place in (_on_device(path, table), *inner):
        for mount in table:
            if mount.device == device and within(place, [mount.root]):
                other = _join(mount.point, place[len(mount.root.rstrip("/")) :])
            elif mount.device == device and within(mount.root, [place]):
                other = mount.point
            else:
                continue
            if not within(other, [path]):
                yield other


def _plain(field: str) -> str:
    return _ESCAPED.sub(lambda match: chr(int(match[1], 8)), field)


def _on_device(path: str, table: Sequence[Mount]) -> tuple[str, str]:
    """The device on which it lies, and where on that."""
    own = Mount("", "/", "")
    for mount in table:  # of two at one place the later one is seen
        if within(path, [mount.point]) and len(mount.point) >= len(own.point):
            own = mount
    return own.device, _join(own.root, path[len(own.point.rstrip("/")) :])


def _join(folder: str, rest: str) -> str:
    return folder.rstrip("/") + rest or "/"


def open_to_all(paths: Iterable[str], *, below: bool) -> bool:
    """Whether somebody who owns nothing can read them; without `below` every folder on the way counts."""
    found = [Path(path) for path in paths if Path(path).exists()]
    parts = found if below else [part for place in found for part in (place, *place.parents)]
    return all(map(_open_to_all, parts))


def _open_to_all(path: Path) -> bool:
    mode = path.stat().st_mode
    needed = 0o5 if path.is_dir() else 0o4
    return mode & needed == needed
