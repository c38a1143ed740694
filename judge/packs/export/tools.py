"""verifyproblem and bt, who check packages, where they are installed.

Both run the validators and programs of a package with the rights of whoever calls them.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from msgspec import Struct

from judge.packs.export.metadata import Version

BESIDE = Path(sys.executable).parent  # where pip puts them
PATIENCE = 3600.0  # seconds for one package
NO_SETTINGS: Mapping[str, str] = MappingProxyType({})
_COLOUR = re.compile(r"\x1b\[[0-9;]*m")  # in a build they colour what they write into a pipe
_COUNTS = re.compile(r"tested: (\d+) errors?, (\d+) warnings?")
_PARTS = ("config", "data", "graders", "validators")
# What bt writes where nothing is wrong: any other line is a remark.
_QUIET = re.compile(r"\s*$|PROBLEM |LOG: |.*: Done$|.*: using test case|.*: Generated ", re.DOTALL)
_KNOWN = {  # warnings that say nothing of the package
    "License is 'unknown'": "no license is chosen: [source] in problem.toml may name one",
    "Command 'tidy' not found": "the statement's HTML is not checked: there is no tidy",
}


class Tool(Struct, frozen=True):
    """A program that checks packages of one version; `package` is what pip installs."""

    name: str
    package: str


TOOLS = {Version.LEGACY: Tool("verifyproblem", "problemtools"), Version.NEW: Tool("bt", "bapctools")}


class Checked(Struct, frozen=True):
    """What a tool says of a package: `lines` are its errors and warnings, `notes` what it did not look at."""

    tool: str
    ok: bool
    errors: int
    warnings: int
    lines: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def found(version: Version) -> str | None:
    """Where the tool for packages of that version is: on the path, or beside this Python."""
    name = TOOLS[version].name
    beside = BESIDE / name
    return shutil.which(name) or (str(beside) if os.access(beside, os.X_OK) else None)


def missing(version: Version) -> str:
    """What to do to have the tool."""
    tool = TOOLS[version]
    return f"{version.value} is not checked: {tool.name} is not installed; pip install {tool.package}"


def check(package: Path, version: Version, *, held: bool) -> Checked:
    """Let the tool for that version look at a package; `held` says that it holds programs."""
    path = found(version)
    assert path is not None
    place = package.absolute()  # a tool runs beside the package
    return _verified(path, place, held) if version is Version.LEGACY else _validated(path, place)


def _verified(tool: str, package: Path, held: bool) -> Checked:
    parts = [*_PARTS, *(["submissions"] if held else [])]
    notes = [] if held else ["without programs it tries none"]
    if shutil.which("lualatex"):
        parts.append("statement")
    else:
        notes.append("the statement is not checked: there is no lualatex")
    status, output = _run([tool, str(package), "--parts", *parts], package.parent)
    counts = _COUNTS.search(output)
    lines = tuple(line.strip() for line in output.splitlines() if line.startswith(("ERROR", "WARNING")))
    if counts is None:
        return Checked("verifyproblem", False, 1, 0, _last(output, status), tuple(notes))
    errors, warnings = int(counts[1]), int(counts[2])
    excused = [word for line in lines for sign, word in _KNOWN.items() if sign in line]
    ok = not errors and warnings <= len(excused)
    return Checked("verifyproblem", ok, errors, warnings, lines, (*notes, *excused))


def _validated(tool: str, package: Path) -> Checked:
    # It remembers where a uuid was, and warns of the same problem in another place.
    with tempfile.TemporaryDirectory() as own:
        words = [tool, "validate", "--no-bar", "--problem", str(package)]
        status, output = _run(words, package.parent, {"XDG_CONFIG_HOME": own, "HOME": own})
    remarks = tuple(line.strip() for line in output.splitlines() if not _QUIET.match(line))
    if status and not remarks:
        remarks = _last(output, status)
    errors = 1 if status else 0
    return Checked("bt", not status and not remarks, errors, len(remarks) - errors, remarks)


def _last(output: str, status: int) -> tuple[str, ...]:
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return (*lines[-3:], f"it ended with status {status}")


def _run(command: list[str], folder: Path, settings: Mapping[str, str] = NO_SETTINGS) -> tuple[int, str]:
    """Its status and all that it says; whatever it has started ends with it."""
    process = subprocess.Popen(
        command,
        cwd=folder,
        env={**os.environ, **settings},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    try:
        output, _ = process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        _end(process)
        return 1, f"nothing came of it within {PATIENCE:.0f} s"
    except BaseException:
        _end(process)
        raise
    return process.returncode, _COLOUR.sub("", output.decode(errors="replace"))


def _end(process: subprocess.Popen[bytes]) -> None:
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
