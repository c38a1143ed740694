"""Languages that other distributions bring: folders that entry points of the group `judge.languages` name."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path

from judge.errors import JudgeError

GROUP = "judge.languages"


def installed_folders() -> list[Path]:
    """The folder of each: of the package that the entry point names, or a path that it holds.

    Raises JudgeError where one cannot be loaded, or is no folder.
    """
    folders = []
    for point in entry_points(group=GROUP):
        where, remedy = f"entry point {point.value}", "repair or uninstall it"
        try:
            named = point.load()
            folder = Path(named if isinstance(named, str | Path) else named.__path__[0])
        except (Exception, SystemExit) as fault:  # foreign code: whatever it raises is one clear line
            what = f"the languages {point.name!r} cannot be loaded: {type(fault).__name__}: {fault}"
            raise JudgeError(what, where=where, remedy=remedy) from fault
        if not folder.is_dir():
            what = f"the languages {point.name!r} are to lie in {folder}, which is not a folder"
            raise JudgeError(what, where=where, remedy=remedy)
        folders.append(folder.resolve())
    return folders
