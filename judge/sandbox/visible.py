"""What a container may see of this machine: the interpreter, its libraries, the modules installed for it.

It is a list. Not on it, wherever they lie, are the judge, packs of problems with their solutions, built data,
and what is like them among modules; nor other Pythons, with theirs, in a folder of libraries.

Everything is decided on real paths: inside, each folder lies at its own, once, and the symlinks that lead to
it are made again. So what is covered at its real path is covered by every name.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from judge.errors import UsageError
from judge.sandbox import places
from judge.sandbox.inside import unseen
from judge.sandbox.places import real, within

SITE_NAMES = ("site-packages", "dist-packages")
_LIBRARIES = ("/usr/lib", "/usr/lib64", "/usr/lib32", "/usr/libx32", "/usr/local/lib", "/lib", "/lib64")
_OF_A_MACHINE = re.compile(r"\w+-linux-\w+")  # where a system that has them keeps its shared libraries
_BESIDE_THEM = re.compile(rf"{_OF_A_MACHINE.pattern}|(?:lib|ld-).*\.so.*|locale")
_LOADER_CACHE = "/etc/ld.so.cache"
_ZONES = "/usr/share/zoneinfo"  # of the times of the world
_DEVICES = ("/dev/null", "/dev/urandom")
_PACKAGES = "JUDGE_PACKAGES"  # more folders of modules, parted by the system's own sign
_STORES = ("/nix/store", "/gnu/store")
_INFO = re.compile(r"circle_line_judge-.*\.dist-info")  # it names every file of the judge, and its checkout


class Visible(NamedTuple):
    """Absolute paths: `links` by where they lie, `searched` by any name, the others real.

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
        return places.open_to_all(named, below=below)


def visible(hide: Iterable[Path] = (), more: Iterable[str] = (), *, modules: bool = True) -> Visible:
    """What is seen with the interpreter that runs the judge.

    `hide` are more folders that must not be, `more` files and folders that must, as a compiler's. Without
    `modules` those that are installed for any Python here are hidden, and `$JUDGE_PACKAGES` is not shown.
    Raises UsageError where that names what is no folder.
    """
    executable, more = real(sys.executable), tuple(more)
    path, libraries = [places.absolute(entry) for entry in sys.path], _libraries()
    standard, installed = _parted(path)
    sites = [*installed, *package_folders()] if modules else []
    parts = [part for folder in libraries.values() for part in _of_a_library(folder)]
    stores = [store for store in _STORES if executable.startswith(store)]
    names = (executable, _LOADER_CACHE, _ZONES, *parts, *standard, *stores, *sites, *more)
    wanted = {name: real(name) for name in names if os.path.exists(name)}  # noqa: PTH110 - False if closed
    folders = places.outermost(place for place in wanted.values() if os.path.isdir(place))  # noqa: PTH112
    links = dict(link for name in (libraries | wanted).items() for link in places.links_on(*name))
    shown = [*wanted.values(), *_DEVICES, *links]
    others = [each for folder in libraries.values() if folder in folders for each in _pythons(folder)]
    # Those that a virtual environment leaves alone are seen with the standard library that it takes.
    unused = [f"{entry}/{site}" for entry in (*standard, *others) for site in SITE_NAMES]
    searched = dict.fromkeys((*path, *sites, *(str(Path(each).parent) for each in _packages()), *unused))
    secret = _secret(hide, searched, shown)
    others += [] if modules else [*installed, *unused]
    needed = [*standard, *(wanted[name] for name in (*sites, *more) if name in wanted)]
    others = [each for each in map(real, others) if not any(within(need, [each]) for need in needed)]
    hidden = (each for each in (*secret, *others) if within(each, folders) and os.path.isdir(each))  # noqa: PTH112
    return Visible(
        executable=executable,
        folders=tuple(folders),
        files=tuple(dict.fromkeys(place for place in wanted.values() if not within(place, folders))),
        links=tuple(link for link in links.items() if not within(link[0], folders)),
        # What lies in a hidden folder is hidden with it; an empty one could not be laid over it once more.
        hidden=tuple(places.outermost(hidden)),
        imports=tuple(dict.fromkeys((*standard, *map(real, sites)))),
        unseen=tuple(_with_files(each for each in secret if not _surrounds(each, shown))),
        searched=tuple(searched),
    )


def package_folders(name: str = "") -> list[str]:
    """The real folders that `$JUDGE_PACKAGES` names; those called `name` alone, where that is given."""
    named = [real(each) for each in os.environ.get(_PACKAGES, "").split(os.pathsep) if each]
    for each in named:
        if not Path(each).is_dir():
            what = f"${_PACKAGES} names {each}, which is not a folder"
            raise UsageError(what, remedy=f"make it with: pip install --target {each} PACKAGE")
    return [each for each in named if not name or Path(each).name == name]


def _around_it() -> list[str]:
    """The folders in which the interpreter's own libraries are."""
    prefixes, parts = (sys.base_prefix, sys.base_exec_prefix), ("lib", sys.platlibdir)
    return [f"{prefix}/{part}" for prefix in prefixes for part in parts]


def _libraries() -> dict[str, str]:
    """The folders of libraries that are here, by their names, where they really lie."""
    names = dict.fromkeys((*_LIBRARIES, *_around_it()))
    return {name: real(name) for name in names if os.path.isdir(name)}  # noqa: PTH112 - hot


def _parted(path: Iterable[str]) -> tuple[list[str], list[str]]:
    """Of the entries of sys.path the real ones of the interpreter itself, then those of installed modules."""
    around = [real(each) for each in _around_it()]
    installed = [entry for entry in path if _is_site(entry)]
    standard = [real(entry) for entry in path if entry not in installed]
    return [entry for entry in standard if within(entry, around)], installed


def _of_a_library(folder: str) -> list[str]:
    """What is shown of a folder of libraries: all of it, or what is no folder but that of the machine."""
    entries = places.listed(folder)
    if not any(map(_OF_A_MACHINE.fullmatch, entries)):
        return [folder]
    return [f"{folder}/{name}" for name in entries if _BESIDE_THEM.fullmatch(name)]


def _pythons(folder: str) -> list[str]:
    """What lies there of any Python."""
    return [f"{folder}/{name}" for name in places.listed(folder) if name.startswith("python")]


def _secret(hide: Iterable[Path], entries: Iterable[str], shown: Sequence[str]) -> list[str]:
    """The real paths of what must not be seen, other mounts of it included.

    That is `hide`, the judge, and its like among `entries`; a checkout that has something of `shown` in it,
    such as the virtual environment in use, counts by its parts.
    """
    named = [*_packages(), *map(str, hide), *_ours(entries, shown)]
    found = [path for path in dict.fromkeys(map(real, named)) if os.path.exists(path)]  # noqa: PTH110
    if sys.pycache_prefix:
        found.append(real(sys.pycache_prefix))
    table = places.mounts()
    return list(dict.fromkeys([*found, *(each for path in found for each in places.elsewhere(path, table))]))


def _ours(entries: Iterable[str], shown: Sequence[str]) -> Iterator[str]:
    """The real paths of the folders in the entries that are the judge's, or like them."""
    for entry in entries:
        for name in unseen.NAMES:
            folder = f"{entry.rstrip('/')}/{name}"
            if not _is_ours(folder, name):
                continue
            place = real(folder)
            if not _surrounds(place, shown):
                yield place
            elif _surrounds(real(entry), [place]):  # downwards only, or it might never end
                yield from _ours([place], shown)
        if _is_site(entry):
            yield from (real(f"{entry}/{each}") for each in places.listed(entry) if _INFO.fullmatch(each))


def _is_site(entry: str) -> bool:
    return os.path.basename(entry.rstrip("/")) in SITE_NAMES  # noqa: PTH119 - hot


def _is_ours(folder: str, name: str) -> bool:
    try:
        return os.path.isdir(folder) and unseen.is_ours(folder, name)  # noqa: PTH112 - pathlib is slower
    except OSError:
        return True  # nobody has to see it


def _packages() -> list[str]:
    """The judge's own folder, as it is imported and where its files lie; of an archive, the archive."""
    here = Path(places.absolute(__file__))
    packages = []
    for package in (here.parent.parent, here.resolve().parent.parent):
        while not package.exists():
            package = package.parent
        packages.append(str(package))
    return packages


def _surrounds(folder: str, shown: Iterable[str]) -> bool:
    return any(place != folder and place.startswith(f"{folder.rstrip('/')}/") for place in shown)


def _with_files(folders: Iterable[str]) -> Iterator[str]:
    """Each, and then some file in it, which may be open to who may not list the folder."""
    for folder in folders:
        yield folder
        for place, _, files in os.walk(folder, onerror=places.refuse_shortage):
            if files:
                yield f"{place}/{files[0]}"
                break


def _around(folder: str, hidden: Sequence[str]) -> list[str]:
    """The folder, or where something hidden lies below it, its entries around that, but no symlink.

    A rule holds for what a symlink leads to; where that is shown, it has a rule of its own.
    """
    if folder in hidden:
        return []
    inside = [path for path in hidden if within(path, [folder])]
    if not inside:
        return [folder]
    entries = sorted(entry.path for entry in os.scandir(folder) if not entry.is_symlink())
    return [path for entry in entries for path in _around(entry, inside)]
