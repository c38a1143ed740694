"""What a package says of itself: its short name, its uuid, and problem.yaml in both versions."""

from __future__ import annotations

import json
import uuid
from enum import Enum

from judge.problem import Problem
from judge.problem.model import Source

MEMORY_MB = 1024  # at least: PyPy starts with less in vain
LICENSES = ("public domain", "cc0", "cc by", "cc by-sa", "educational", "permission")
UNKNOWN = "unknown"
_NAMESPACE = uuid.UUID("6f0d3c1e-3c63-5b7e-9d53-0d2f5f1a9c11")


class Version(Enum):
    """A version of the format."""

    LEGACY = "legacy"
    NEW = "2025-09"


def short_name(problem: str) -> str:
    """What a package is called: small letters and digits."""
    return problem.replace("-", "")


def uuid_of(problem: str, version: Version) -> str:
    """The same for every export of the problem in that version."""
    return str(uuid.uuid5(_NAMESPACE, f"{problem}/{version.value}"))


def license_of(source: Source) -> str:
    """The license as the format knows it; `unknown` where it does not, or none was chosen."""
    return source.license.lower() if source.license.lower() in LICENSES else UNKNOWN


def problem_yaml(problem: Problem, version: Version, seconds: int) -> str:
    """The file problem.yaml; `seconds` is the time limit, which in the legacy format the solutions set."""
    source, legacy = problem.source, version is Version.LEGACY
    form = "interactive" if problem.talks else "pass-fail"
    rows = [] if legacy else ["problem_format_version: 2025-09", f"type: {form}"]
    rows += [f"name: {_text(problem.title)}", f"uuid: {uuid_of(problem.id, version)}"]
    if source.authors and legacy:
        rows.append(f"author: {_text(', '.join(source.authors))}")
    elif source.authors:
        rows += ["credits:", "  authors:", *(f"    - {_text(author)}" for author in source.authors)]
    if source.origin:
        rows.append(f"source: {_text(source.origin)}")
    rows.append(f"license: {license_of(source)}")
    if legacy:
        rows.append("validation: custom interactive" if problem.talks else "validation: custom")
    rows.append("limits:")
    if not legacy:
        rows.append(f"  time_limit: {seconds}.0")
    return "\n".join([*rows, f"  memory: {memory(problem)}"]) + "\n"


def memory(problem: Problem) -> int:
    """The memory limit, in MB."""
    limits = problem.limits, *map(problem.limits_of, problem.groups)
    return max(MEMORY_MB, *(each.memory_bytes >> 20 for each in limits))


def domjudge_ini(problem: Problem, seconds: int) -> str:
    """The file domjudge-problem.ini."""
    return f"short-name={short_name(problem.id)}\nname={_ini(problem.title)}\ntimelimit={seconds}\n"


def _text(text: str) -> str:
    """A YAML scalar: JSON's strings are some."""
    return json.dumps(text, ensure_ascii=False)


def _ini(text: str) -> str:
    """A value between quotation marks, which PHP reads with nothing to escape one."""
    return "'" + text.replace("'", "’") + "'"
