"""The test files of a package, samples first, in the order of their names.

The arguments for the output validator come from the innermost file that names any:

    legacy     those of problem.yaml, and then of testdata.yaml in the test file's folder or the nearest above
    2025-09    those of <case>.yaml, or of test_group.yaml in the same folders
"""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError, UsageError
from judge.packs.foreign.package import LEGACY, Package
from judge.packs.foreign.settings import read_settings, words

_DATA = "data"
_PARTS = ("sample", "secret")
_GROUP = {LEGACY: ("testdata.yaml", "output_validator_flags")}
_NEW_GROUP = ("test_group.yaml", "output_validator_args")


class DataFile(Struct, frozen=True):
    """One test file: `name` is `secret/01`, `flags` are for the output validator."""

    name: str
    given: Path
    answer: Path
    flags: tuple[str, ...]


def test_files(package: Package) -> list[DataFile]:
    """All of them.

    Raises:
        ProblemError: there are none, an answer is missing, a link leads out of the package, or they are more
            than the package may have.
        UsageError: one is run in a way that is not known here.
    """
    opened, found, left = package.opened, [], package.bounds.data
    settings: dict[Path, tuple[str, ...] | None] = {}
    for part in _PARTS:
        folder = opened.root / _DATA / part
        for path in sorted(opened.walk(folder), key=lambda each: each.parts):
            if path.suffix != ".in":
                continue
            answer = path.with_suffix(".ans")
            if not answer.is_file():
                raise ProblemError("there is no answer file beside it", where=opened.name_of(path))
            opened.check(answer)
            left -= opened.size(path) + opened.size(answer)
            if left < 0:
                most = f"the test files together are larger than {package.bounds.data >> 20:,} MB"
                raise ProblemError(most, where=package.name, remedy="--package-limits allows more")
            if path.with_suffix(".files").exists():
                what = "this test file comes with files of its own, which is not judged"
                raise UsageError(what, where=opened.name_of(path))
            name = path.relative_to(opened.root / _DATA).with_suffix("").as_posix()
            found.append(DataFile(name, path, answer, _flags(package, path, settings)))
    if not found:
        what = f"there is no test file in {_DATA}/{' or '.join(_PARTS)}"
        raise ProblemError(what, where=package.name, remedy="generate them first")
    return found


def _flags(package: Package, path: Path, settings: dict[Path, tuple[str, ...] | None]) -> tuple[str, ...]:
    """The arguments for one test file; `settings` are those of the folders that were asked before."""
    if package.form != LEGACY:
        own = _said(package, path.with_suffix(".yaml"), _NEW_GROUP[1])
        if own is not None:
            return own
    file, key = _GROUP.get(package.form, _NEW_GROUP)
    top = package.opened.root / _DATA
    for folder in path.parents:
        if folder not in settings:
            settings[folder] = _said(package, folder / file, key)
        found = settings[folder]
        if found is not None:
            return (*package.flags, *found)
        if folder == top:
            break
    return package.flags


def _said(package: Package, path: Path, key: str) -> tuple[str, ...] | None:
    """What a YAML file says under a key; None where there is no such file, or nothing there."""
    if not path.is_file():
        return None
    where = package.opened.name_of(path)
    said = read_settings(package.opened, path)
    if said.get("args"):
        what = "its submissions are run with arguments, which is not judged"
        raise UsageError(what, where=where)
    value = said.get(key)
    return None if value is None else words(value, key, where)
