"""What a package says of itself in problem.yaml, and why some are refused."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError, UsageError
from judge.packs.foreign.look import DESCRIPTION
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.settings import Settings, number, read_settings, section, words
from judge.sandbox import room
from judge.sandbox.boundary import Limits

LEGACY, NEW = FORMATS = "legacy", "2025-09"
_NAMES_OF_LEGACY = ("legacy", "legacy-icpc")
_MEMORY_MB, _OUTPUT_MB, _VALIDATION_SECONDS = 2048, 8, 60
_MB = 1 << 20
_SPARE_MB = 512  # of the machine's memory that no submission is given
_GRACE = 1.0  # seconds by the clock beyond those of CPU time, so that work is not taken for waiting
_RESERVED = 2  # times its memory that a process may reserve
_NO = {
    "interactive": "the output validator talks to the submission while it runs",
    "scoring": "submissions get a score",
    "multi-pass": "a submission is run several times on what the output validator writes",
    "submit-answer": "what is submitted is no program",
}
_UNUSUAL = {
    "include": "its include/ adds files to each submission",
    "static_validator": "its static validator reads the submission's source",
}


class Bounds(Struct, frozen=True):
    """The most that is believed of a package's limits.

    `memory` and `output` are MB, `seconds` those of CPU time of a submission on a test file, `validating`
    those of an output validator by the clock, `data` the bytes of all test files.
    """

    memory: float
    output: float
    seconds: float
    validating: float
    data: int


OURS = Bounds(2048, 64, 60, 60, 1 << 30)
THEIRS = Bounds(1 << 20, 256, 3600, 3600, 1 << 40)
"""What a limit may be at all; `--package-limits` takes these for bounds."""


class TimeRule(Struct, frozen=True):
    """How the time limit is found: `fixed` in seconds, or the slowest accepted one's times `factor`.

    `margin` is a factor too: what takes more than the limit but no more than so many of it is a close call.
    `resolution` is what the limit is a multiple of: it is rounded up. It is `most` seconds in any case.
    """

    fixed: float | None
    factor: float
    margin: float
    resolution: float = 1.0
    most: float = OURS.seconds


class Package(Struct, frozen=True):
    """A pass–fail package.

    `validator` is the file or folder of its own output validator, `flags` are the arguments for all test
    files; `memory_bytes` and `output_bytes` bound a submission, `validating` its output validator. `lowered`
    says of each limit that is lower here than the package wants, by its name, what it wants.
    """

    opened: Opened
    form: str
    time: TimeRule
    memory_bytes: int
    output_bytes: int
    validating: Limits
    validator: Path | None
    bounds: Bounds
    lowered: Mapping[str, str]
    flags: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name of its folder."""
        return self.opened.name


def read_package(opened: Opened, bounds: Bounds = OURS) -> Package:
    """The package, as its problem.yaml describes it, with no limit above a bound or what this machine has.

    Raises:
        UsageError: it is of a kind or a format that is not judged here; PyYAML is missing.
        ProblemError: it is broken.
    """
    said = read_settings(opened, opened.root / DESCRIPTION)
    refused = _kinds(said)
    for kind in _NO:
        if kind in refused:
            raise _refusal(f"{kind} problems are not judged: {_NO[kind]}")
    form = _form(said)
    for folder, why in _UNUSUAL.items():
        if any(opened.entries(folder)):
            raise _refusal(f"this package is not judged: {why}")
    if form == NEW and said.get("constants"):
        raise _refusal("this package is not judged: its constants are to be put into its programs")
    limits = _Limits(section(said, "limits", DESCRIPTION), bounds)
    memory = limits.memory("memory", bounds.memory)
    output = limits.bounded("output", _OUTPUT_MB, THEIRS.output, bounds.output, "MB")
    validating = limits.validating()
    return Package(
        opened,
        form,
        _time_rule(limits.said, form, bounds),
        int(memory * _MB),
        int(output * _MB),
        validating,
        _validator(opened, said, form),
        bounds,
        limits.lowered,
        words(said.get("validator_flags") or "", "validator_flags", DESCRIPTION) if form == LEGACY else (),
    )


def _refusal(what: str) -> UsageError:
    return UsageError(what, where=DESCRIPTION, remedy="pass-fail packages alone are, as their files are")


def _form(said: Settings) -> str:
    version = str(said.get("problem_format_version", LEGACY))
    if version in _NAMES_OF_LEGACY:
        return LEGACY
    if version == NEW:
        return NEW
    what = f"packages of the format {version[:40]!r} are not judged"
    raise UsageError(what, where=DESCRIPTION, remedy=f"formats are {' and '.join(FORMATS)}")


def _kinds(said: Settings) -> set[str]:
    """All that a package says to be, in the words of the newer format."""
    kinds = set(words(said.get("type") or "pass-fail", "type", DESCRIPTION))
    validation = words(said.get("validation") or "default", "validation", DESCRIPTION)
    also = {"interactive": "interactive", "score": "scoring", "multi-pass": "multi-pass"}
    kinds |= {also[word] for word in validation[1:] if word in also}
    if said.get("grading") == "custom":
        kinds.add("scoring")
    unknown = kinds - {"pass-fail", *_NO}
    if unknown:
        raise ProblemError(f"type is {min(unknown)[:40]!r}, which no package is", where=DESCRIPTION)
    return kinds


def _time_rule(limits: Settings, form: str, bounds: Bounds) -> TimeRule:
    most = bounds.seconds
    if form == LEGACY:
        factor = number(limits, "time_multiplier", 5, 1, 1000, DESCRIPTION)
        margin = number(limits, "time_safety_margin", 2, 1, 1000, DESCRIPTION)
        return TimeRule(None, factor, margin, most=most)
    factors = section(limits, "time_multipliers", DESCRIPTION)
    resolution = number(limits, "time_resolution", 1, 1e-3, THEIRS.seconds, DESCRIPTION)
    given = number(limits, "time_limit", 0, 1e-3, THEIRS.seconds, DESCRIPTION)
    factor = number(factors, "ac_to_time_limit", 2, 1, 1000, DESCRIPTION)
    margin = number(factors, "time_limit_to_tle", 1.5, 1, 1000, DESCRIPTION)
    return TimeRule(given or None, factor, margin, resolution, most)


class _Limits:
    """The limits that a package names, each bounded; `lowered` fills with those that it wants higher."""

    def __init__(self, said: Settings, bounds: Bounds) -> None:
        self.said = said
        self.lowered: dict[str, str] = {}
        self._bounds = bounds
        self._machine = max(1.0, (room.memory_left() / _MB - _SPARE_MB) // _RESERVED)

    def bounded(
        self, key: str, usual: float, most: float, bound: float, unit: str, whose: str = "the judge"
    ) -> float:
        """The number under a key, the bound where it is more. Raises ProblemError for no such number."""
        wanted = number(self.said, key, usual, 1, most, DESCRIPTION)
        if wanted > bound:
            raised = "; --package-limits allows more" if whose == "the judge" and bound < most else ""
            self.lowered[key] = (
                f"limits.{key} is {wanted:,.15g} {unit}, and {whose} allows {bound:,.15g}{raised}"
            )
        return min(wanted, bound)

    def memory(self, key: str, bound: float) -> float:
        """MB; a process may reserve more than it uses."""
        whose = "the judge" if bound <= self._machine else "this machine"
        return self.bounded(key, _MEMORY_MB, THEIRS.memory, min(bound, self._machine), "MB", whose)

    def validating(self) -> Limits:
        """Those of an output validator, which may wait no longer than it may work, by the clock."""
        bounds, key = self._bounds, "validation_time"
        seconds = self.bounded(key, _VALIDATION_SECONDS, THEIRS.validating, bounds.validating, "s")
        memory = self.memory("validation_memory", bounds.memory)
        output = self.bounded("validation_output", _OUTPUT_MB, THEIRS.output, bounds.output, "MB")
        return Limits(seconds, seconds + _GRACE, int(memory * _MB), int(output * _MB))


def _validator(opened: Opened, said: Settings, form: str) -> Path | None:
    """Where the package's own output validator lies; None where it is the default one."""
    if form == NEW:
        own = opened.root / "output_validator"
        return own if opened.entries(own.name) else None
    (kind, *_) = words(said.get("validation") or "default", "validation", DESCRIPTION) or ("default",)
    if kind == "default":
        return None
    if kind != "custom":
        raise ProblemError(f"validation is {kind[:40]!r}, and neither default nor custom", where=DESCRIPTION)
    found = opened.entries("output_validators")
    if len(found) == 1:
        return found[0]
    if not found:
        raise ProblemError("validation is custom, but output_validators/ is empty", where=DESCRIPTION)
    raise _refusal(f"there are {len(found)} output validators")
