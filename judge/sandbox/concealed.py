"""What no submission may see wherever it lies: the judge, packs of problems with their solutions, built data.

The judge may be here more than once: installed for the system and in a virtual environment, under a second
mount. Whatever looks like one of its folders where Pythons of this machine keep their modules is meant too.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from judge.sandbox import places
from judge.sandbox.inside import unseen

SITE_NAMES = ("site-packages", "dist-packages")
_INFO = re.compile(
    r"circle_line_judge-.*\.dist-info"
)  # which names every file of the judge, and its checkout


def searched(path: Iterable[str], libraries: Iterable[str]) -> list[str]:
    """Every folder in which modules are looked for, by each of its names.

    The entries of `path`, what lies beside the judge, and the conventional places in library folders, where
    another Python of this machine may look.
    """
    entries = [*path, *(str(Path(package).parent) for package in _packages())]
    for library in dict.fromkeys(map(places.real, libraries)):
        pythons = [f"{library}/{name}" for name in _listed(library) if name.startswith("python3")]
        entries += [f"{python}/{site}" for python in pythons for site in SITE_NAMES]
    return list(dict.fromkeys(entries))


def folders(hide: Iterable[Path], entries: Iterable[str], shown: Sequence[str]) -> list[str]:
    """The real paths of what must not be seen, other mounts of it included.

    That is `hide`, the judge, and its like among `entries`; a checkout that has something of `shown` in it,
    such as the virtual environment in use, counts by its parts.
    """
    named = [*_packages(), *map(str, hide), *ours(entries, shown)]
    found = [path for path in dict.fromkeys(map(places.real, named)) if os.path.exists(path)]  # noqa: PTH110
    if sys.pycache_prefix:
        found += [places.real(sys.pycache_prefix) + path for path in found]
    table = places.mounts()
    return list(
        dict.fromkeys([*found, *(other for path in found for other in places.elsewhere(path, table))])
    )


def ours(entries: Iterable[str], shown: Sequence[str] = ()) -> Iterator[str]:
    """The real paths of the folders in the entries that are the judge's, or like them."""
    for entry in entries:
        for name in unseen.NAMES:
            folder = f"{entry.rstrip('/')}/{name}"
            if not _is_ours(folder, name):
                continue
            place = places.real(folder)
            if not _surrounds(place, shown):
                yield place
            elif _surrounds(places.real(entry), [place]):  # downwards only, or it might never end
                yield from ours([place], shown)
        if Path(entry).name in SITE_NAMES:
            yield from (places.real(f"{entry}/{each}") for each in _listed(entry) if _INFO.fullmatch(each))


def by_every_name(secret: Iterable[str], names: Mapping[str, str], shown: Sequence[str]) -> tuple[str, ...]:
    """The secret folders by each name that leads to one, each followed by a file in it.

    `names` are those of the folders that are shown, with their real paths. A secret folder that has something
    of `shown` in it is left out: it lists that, and nothing else.
    """
    found: list[str] = []
    for folder in secret:
        if _surrounds(folder, shown):
            continue
        file = _first_file(folder)
        also = [
            name + folder[len(place) :] for name, place in names.items() if places.within(folder, [place])
        ]
        found += [path for each in (folder, *also) for path in (each, each + file)]
    return tuple(dict.fromkeys(found))


def _packages() -> list[str]:
    """The judge's own folder, as it is imported and where its files lie; of an archive, the archive."""
    here = Path(places.absolute(__file__))
    packages = []
    for package in (here.parent.parent, here.resolve().parent.parent):
        while not package.exists():
            package = package.parent
        packages.append(str(package))
    return packages


def _surrounds(folder: str, shown: Sequence[str]) -> bool:
    return any(place != folder and places.within(place, [folder]) for place in shown)


def _is_ours(folder: str, name: str) -> bool:
    try:
        return os.path.isdir(folder) and unseen.is_ours(folder, name)  # noqa: PTH112 - pathlib is slower
    except OSError:
        return True  # nobody has to see it


def _listed(folder: str) -> list[str]:
    try:
        return os.listdir(folder)  # noqa: PTH208
    except OSError as fault:
        places.refuse_shortage(fault)
        return []


def _first_file(folder: str) -> str:
    """The end of the path of some file in it, which may be open to who may not list the folder."""
    for place, _, files in os.walk(folder, onerror=places.refuse_shortage):
        if files:
            return f"{place}/{files[0]}"[len(folder) :]
    return ""
