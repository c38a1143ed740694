"""What a container may see of this machine: the interpreter, its libraries, the modules installed for it.

The judge itself may be installed among those modules; it is left out.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

_LIBRARY_FOLDERS = ("/usr/lib", "/usr/lib64", "/usr/lib32", "/usr/libx32", "/usr/local/lib", "/lib", "/lib64")
_LOADER_CACHE = "/etc/ld.so.cache"
_DEVICES = ("/dev/null", "/dev/urandom")
_STORES = ("/nix/store", "/gnu/store")
_SITE_NAMES = ("site-packages", "dist-packages")


class Roots(NamedTuple):
    """Absolute paths as the interpreter knows them.

    `folders` are readable whole but for `hidden`; `files` one by one; `imports` is sys.path inside.
    """

    executable: str
    folders: tuple[str, ...]
    files: tuple[str, ...]
    hidden: tuple[str, ...]
    imports: tuple[str, ...]

    def readable(self) -> list[str]:
        """The paths that are allowed one by one, for a sandbox that cannot cover a folder inside another."""
        allowed: list[str] = []
        for folder in self.folders:
            allowed += _around(Path(folder), [Path(path) for path in self.hidden])
        return [*allowed, *self.files, *_DEVICES]

    def outsiders_may_read(self, *, below: bool) -> bool:
        """Whether somebody who owns nothing can read the interpreter; `below` looks at the folders only."""
        places = [Path(path) for path in (self.executable, *self.imports) if Path(path).exists()]
        if below:
            places += [Path(path) for path in self.folders]
            return all(_open_to_all(place) for place in places)
        return all(_open_to_all(part) for place in places for part in (place, *place.parents))


def find_roots(hide: Iterable[Path] = ()) -> Roots:
    """The roots of the interpreter that runs the judge; `hide` are more folders that must not be seen."""
    executable = str(Path(sys.executable).resolve())
    prefixes = dict.fromkeys((sys.base_prefix, sys.base_exec_prefix))
    libraries = [
        str(Path(prefix, part)) for prefix in prefixes for part in dict.fromkeys(("lib", sys.platlibdir))
    ]
    sites = [path for path in sys.path if Path(path).name in _SITE_NAMES]
    stores = [store for store in _STORES if executable.startswith(store)]
    wanted = [*_LIBRARY_FOLDERS, *libraries, *stores, *sites]
    folders = _outermost(path for path in wanted if Path(path).is_dir())
    package = Path(__file__).resolve().parent.parent
    hidden = [
        str(path)
        for path in dict.fromkeys([package, *(Path(path).resolve() for path in hide)])
        if path.is_dir()
    ]
    own = [path for path in sys.path if path and _within(path, libraries) and path not in sites]
    files = [path for path in (executable, _LOADER_CACHE) if Path(path).exists()]
    return Roots(
        executable=executable,
        folders=tuple(folders),
        files=tuple(files),
        # What lies in a hidden folder is hidden with it; an empty one could not be laid over it once more.
        hidden=tuple(_outermost(path for path in hidden if _within(path, folders))),
        imports=tuple(dict.fromkeys([*own, *sites])),
    )


def _within(path: str, folders: Iterable[str]) -> bool:
    return any(path == folder or path.startswith(folder + os.sep) for folder in folders)


def _outermost(paths: Iterable[str]) -> list[str]:
    """The paths without those that lie below another; symlinks such as /lib stay, by their own name."""
    chosen = list(dict.fromkeys(paths))
    return [path for path in chosen if not _within(path, [other for other in chosen if other != path])]


def _around(folder: Path, hidden: list[Path]) -> list[str]:
    """The folder, or where something hidden lies below it, its entries around that."""
    real = folder.resolve()
    inside = [path for path in hidden if path == real or real in path.parents]
    if not inside:
        return [str(folder)]
    if real in inside:
        return []
    return [path for entry in sorted(real.iterdir()) for path in _around(entry, inside)]


def _open_to_all(path: Path) -> bool:
    mode = path.stat().st_mode
    needed = 0o5 if path.is_dir() else 0o4
    return mode & needed == needed
