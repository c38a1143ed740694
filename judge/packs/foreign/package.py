"""What a package says of itself in problem.yaml, and why some are refused."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError, UsageError
from judge.packs.foreign.look import DESCRIPTION
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.settings import Settings, number, read_settings, section, words
from judge.sandbox.boundary import Limits

LEGACY, NEW = FORMATS = "legacy", "2025-09"
_NAMES_OF_LEGACY = ("legacy", "legacy-icpc")
_MEMORY_MB, _OUTPUT_MB, _VALIDATION_SECONDS = 2048, 8, 60
_MOST_MB, _MOST_OUTPUT_MB, _MOST_SECONDS = 1 << 20, 256, 3600
_PATIENCE, _AT_LEAST = 4.0, 5.0  # wall time for CPU time, and seconds more
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


class TimeRule(Struct, frozen=True):
    """How the time limit is found: `fixed` in seconds, or the slowest accepted one's times `factor`.

    `margin` is a factor too: what takes more than the limit but no more than so many of it is a close call.
    `resolution` is what the limit is a multiple of: it is rounded up.
    """

    fixed: float | None
    factor: float
    margin: float
    resolution: float = 1.0


class Package(Struct, frozen=True):
    """A pass–fail package.

    `validator` is the file or folder of its own output validator, `flags` are the arguments for all test
    files; `memory_bytes` and `output_bytes` bound a submission, `validating` its output validator.
    """

    opened: Opened
    form: str
    time: TimeRule
    memory_bytes: int
    output_bytes: int
    validating: Limits
    validator: Path | None
    flags: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name of its folder."""
        return self.opened.name


def read_package(opened: Opened) -> Package:
    """The package, as its problem.yaml describes it.

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
    limits = section(said, "limits", DESCRIPTION)
    memory = number(limits, "memory", _MEMORY_MB, 1, _MOST_MB, DESCRIPTION)
    output = number(limits, "output", _OUTPUT_MB, 1, _MOST_OUTPUT_MB, DESCRIPTION)
    return Package(
        opened,
        form,
        _time_rule(limits, form),
        int(memory * (1 << 20)),
        int(output * (1 << 20)),
        _validating(limits),
        _validator(opened, said, form),
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


def _time_rule(limits: Settings, form: str) -> TimeRule:
    if form == LEGACY:
        factor = number(limits, "time_multiplier", 5, 1, 1000, DESCRIPTION)
        return TimeRule(None, factor, number(limits, "time_safety_margin", 2, 1, 1000, DESCRIPTION))
    factors = section(limits, "time_multipliers", DESCRIPTION)
    resolution = number(limits, "time_resolution", 1, 1e-3, _MOST_SECONDS, DESCRIPTION)
    given = number(limits, "time_limit", 0, 1e-3, _MOST_SECONDS, DESCRIPTION)
    factor = number(factors, "ac_to_time_limit", 2, 1, 1000, DESCRIPTION)
    margin = number(factors, "time_limit_to_tle", 1.5, 1, 1000, DESCRIPTION)
    return TimeRule(given or None, factor, margin, resolution)


def _validating(limits: Settings) -> Limits:
    seconds = number(limits, "validation_time", _VALIDATION_SECONDS, 1, _MOST_SECONDS, DESCRIPTION)
    memory = number(limits, "validation_memory", _MEMORY_MB, 1, _MOST_MB, DESCRIPTION)
    output = number(limits, "validation_output", _OUTPUT_MB, 1, _MOST_OUTPUT_MB, DESCRIPTION)
    wall = _PATIENCE * seconds + _AT_LEAST
    return Limits(seconds, wall, int(memory * (1 << 20)), int(output * (1 << 20)))


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
