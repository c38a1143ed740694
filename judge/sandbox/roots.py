"""What a container may see of this machine: the interpreter, its libraries, the modules installed for it.

The judge and packs of problems may be installed among those modules; they are left out. Everything is
decided on real paths: inside, each folder lies at its own, once, and the symlinks that lead to it are made
again. So what is covered at its real path is covered by every name.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from judge.errors import UsageError
from judge.sandbox import concealed, places
from judge.sandbox.concealed import SITE_NAMES

_LIBRARY_FOLDERS = ("/usr/lib", "/usr/lib64", "/usr/lib32", "/usr/libx32", "/usr/local/lib", "/lib", "/lib64")
_LOADER_CACHE = "/etc/ld.so.cache"
_ZONES = "/usr/share/zoneinfo"  # of the times of the world
_DEVICES = ("/dev/null", "/dev/urandom")
_PACKAGES = "JUDGE_PACKAGES"  # more folders of modules, parted by the system's own sign
_STORES = ("/nix/store", "/gnu/store")


class Roots(NamedTuple):
    """Absolute paths: `unseen` and `searched` by every name, `links` by where they lie, the others real.

    `folders` are readable whole but for `hidden`; `files` one by one; `imports` is sys.path inside.
    """

    executable: str
    folders: tuple[str, ...]
    files: tuple[str, ...]
    links: tuple[tuple[str, str], ...]  # symlinks outside the folders that lead to them, each with its text
    hidden: tuple[str, ...]
    imports: tuple[str, ...]
    unseen: tuple[str, ...]  # files and folders that must show nothing inside
    searched: tuple[str, ...]  # where modules come from here: no folder of ours may show among them

    def readable(self) -> list[str]:
        """The paths that are allowed one by one, for a sandbox that cannot cover a folder inside another."""
        return [*self.around(self.folders), *self.files, *_DEVICES]

    def around(self, paths: Iterable[str]) -> list[str]:
        """These real paths, or instead of one that has something hidden in it what lies around that."""
        return [each for path in paths for each in _around(path, self.hidden)]

    def outsiders_may_read(self, *, below: bool) -> bool:
        """Whether somebody who owns nothing can read the interpreter; `below` looks at the folders only."""
        named = (self.executable, *self.imports, *(self.folders if below else ()))
        return open_to_all(named, below=below)


def find_roots(hide: Iterable[Path] = (), more: Iterable[str] = (), *, modules: bool = True) -> Roots:
    """The roots of the interpreter that runs the judge.

    `hide` are more folders that must not be seen, `more` files and folders that must be, as a compiler's.
    Without `modules` those that are installed for any Python here are hidden, and `$JUDGE_PACKAGES` is not
    shown. Raises UsageError where that names what is no folder.
    """
    more = tuple(more)
    executable = places.real(sys.executable)
    libraries = _libraries()
    path = [places.absolute(entry) for entry in sys.path]
    sites = (
        [*(entry for entry in path if Path(entry).name in SITE_NAMES), *package_folders()] if modules else []
    )
    stores = [store for store in _STORES if executable.startswith(store)]
    names = dict.fromkeys((*_LIBRARY_FOLDERS, _ZONES, *libraries, *stores, *sites, *more))
    wanted = {name: places.real(name) for name in names if os.path.isdir(name)}  # noqa: PTH112 - hot
    folders = places.outermost(wanted.values())
    single = [name for name in names if name not in wanted]
    asked = (executable, _LOADER_CACHE, *single)
    files = {name: places.real(name) for name in asked if os.path.exists(name)}  # noqa: PTH110 - False if closed
    links = dict(link for name, real in (wanted | files).items() for link in places.links_on(name, real))
    shown = [*wanted.values(), *files.values(), *_DEVICES, *links]
    searched = concealed.searched((*path, *sites), (*_LIBRARY_FOLDERS, *libraries))
    secret = concealed.folders(hide, searched, shown)
    covered = [*secret, *([] if modules else _installed(searched, more))]
    return Roots(
        executable=executable,
        folders=tuple(folders),
        files=tuple(files.values()),
        links=tuple(link for link in links.items() if not places.within(link[0], folders)),
        # What lies in a hidden folder is hidden with it; an empty one could not be laid over it once more.
        hidden=tuple(places.outermost(path for path in covered if _coverable(path, folders))),
        imports=_imports(path, sites, libraries),
        unseen=concealed.by_every_name(secret, wanted, shown),
        searched=tuple(searched),
    )


def package_folders(name: str = "") -> list[str]:
    """The real folders that `$JUDGE_PACKAGES` names; those called `name` alone, where that is given."""
    named = [places.real(each) for each in os.environ.get(_PACKAGES, "").split(os.pathsep) if each]
    for each in named:
        if not Path(each).is_dir():
            what = f"${_PACKAGES} names {each}, which is not a folder"
            raise UsageError(what, remedy=f"make it with: pip install --target {each} PACKAGE")
    return [each for each in named if not name or Path(each).name == name]


def _libraries() -> list[str]:
    prefixes = dict.fromkeys((sys.base_prefix, sys.base_exec_prefix))
    parts = dict.fromkeys(("lib", sys.platlibdir))
    return [str(Path(prefix, part)) for prefix in prefixes for part in parts]


def _installed(searched: Iterable[str], more: Iterable[str]) -> list[str]:
    """The real folders of modules that are installed for a Python, but for those with something wanted."""
    wanted = [places.real(name) for name in more]
    found = dict.fromkeys(places.real(entry) for entry in searched if Path(entry).name in SITE_NAMES)
    return [folder for folder in found if not any(places.within(each, [folder]) for each in wanted)]


def _imports(path: list[str], sites: list[str], libraries: list[str]) -> tuple[str, ...]:
    """The entries of sys.path that belong to the interpreter, then those of installed modules, all real."""
    own = [places.real(entry) for entry in path if Path(entry).name not in SITE_NAMES]
    among = [places.real(library) for library in libraries]
    own = [entry for entry in own if places.within(entry, among)]
    return tuple(dict.fromkeys([*own, *map(places.real, sites)]))


def _coverable(path: str, folders: Iterable[str]) -> bool:
    return places.within(path, folders) and Path(path).is_dir()


@cache
def _around(folder: str, hidden: tuple[str, ...]) -> list[str]:
    """The folder, or where something hidden lies below it, its entries around that, but no symlink.

    A rule holds for what a symlink leads to; where that is shown, it has a rule of its own.
    """
    if folder in hidden:
        return []
    inside = tuple(path for path in hidden if places.within(path, [folder]))
    if not inside:
        return [folder]
    entries = sorted(entry.path for entry in os.scandir(folder) if not entry.is_symlink())
    return [path for entry in entries for path in _around(entry, inside)]


def open_to_all(paths: Iterable[str], *, below: bool) -> bool:
    """Whether somebody who owns nothing can read them; without `below` every folder on the way counts."""
    found = [Path(path) for path in paths if Path(path).exists()]
    parts = found if below else [part for place in found for part in (place, *place.parents)]
    return all(map(_open_to_all, parts))


def _open_to_all(path: Path) -> bool:
    mode = path.stat().st_mode
    needed = 0o5 if path.is_dir() else 0o4
    return mode & needed == needed
