"""What the submissions of a package should come to.

    legacy     the folder's name says the verdict, or a tag in the source, `@EXPECTED_RESULTS@: TIMELIMIT`
    2025-09    verdicts that each test file may have, and some of which one must have: by the folder's name,
               or by the patterns of submissions.yaml

Memory and output limits count as run-time errors here, as in the formats.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from msgspec import Struct

from judge.errors import ProblemError
from judge.packs.foreign.package import LEGACY, Package
from judge.packs.foreign.programs import Content
from judge.packs.foreign.settings import Settings, read_settings, section, words
from judge.problem.verdict import Verdict

FOLDER = "submissions"
_PATTERNS = "submissions.yaml"
_ALL = frozenset({Verdict.AC, Verdict.WA, Verdict.TLE, Verdict.RTE})
_FAILED = _ALL - {Verdict.AC}
_AS_RTE = {Verdict.MLE: Verdict.RTE, Verdict.OLE: Verdict.RTE}
_TAG = re.compile(rb"@EXPECTED_RESULTS@\s*:?[ \t]*([A-Za-z_, \t-]+)")
_WORDS = {
    "CORRECT": Verdict.AC,
    "ACCEPTED": Verdict.AC,
    "WRONG-ANSWER": Verdict.WA,
    "NO-OUTPUT": Verdict.WA,
    "TIMELIMIT": Verdict.TLE,
    "TIME-LIMIT-EXCEEDED": Verdict.TLE,
    "RUN-ERROR": Verdict.RTE,
    "RUN-TIME-ERROR": Verdict.RTE,
    "COMPILER-ERROR": Verdict.CE,
}
_LOOKED_AT = {"permitted", "required"}
_NO_MATTER = {"authors", "model_solution"}
_MOST_WAYS = 64  # that the braces of a pattern may stand for
_BRACES = re.compile(r"\{([^{}]*)\}")


class Demand(Struct, frozen=True):
    """Each test file's verdict must be among `permitted`, and one of them among `required`.

    A `final` set is one that the submission's own verdict must be in, whatever the others are.
    """

    permitted: frozenset[Verdict] = _ALL
    required: frozenset[Verdict] = _ALL
    final: frozenset[Verdict] | None = None

    def met(self, verdict: Verdict, verdicts: Collection[Verdict]) -> bool:
        """Whether a submission keeps to it, whose test files came to these."""
        if verdict is Verdict.JE:
            return False
        plain = {_AS_RTE.get(each, each) for each in (*verdicts, verdict)}
        if self.final is not None:
            return _AS_RTE.get(verdict, verdict) in self.final
        return plain <= self.permitted and not plain.isdisjoint(self.required)

    def goes_on(self, verdicts: Collection[Verdict]) -> bool:
        """Whether a submission that has failed has still to be looked at further."""
        plain = {_AS_RTE.get(each, each) for each in verdicts}
        return (
            self.final is None and plain <= self.permitted and plain.isdisjoint(self.required - {Verdict.AC})
        )


class Own(Struct, frozen=True):
    """One of the package's own submissions: its path, its folder's name, and what is asked of it."""

    path: Path
    name: str
    folder: str
    demands: tuple[Demand, ...]


_LEGACY_FOLDERS = {
    "accepted": Verdict.AC,
    "wrong_answer": Verdict.WA,
    "time_limit_exceeded": Verdict.TLE,
    "run_time_error": Verdict.RTE,
}
_NEW_FOLDERS = {
    "accepted": Demand(frozenset({Verdict.AC})),
    "rejected": Demand(required=_FAILED),
    "wrong_answer": Demand(frozenset({Verdict.AC, Verdict.WA}), frozenset({Verdict.WA})),
    "time_limit_exceeded": Demand(frozenset({Verdict.AC, Verdict.TLE}), frozenset({Verdict.TLE})),
    "run_time_error": Demand(frozenset({Verdict.AC, Verdict.RTE}), frozenset({Verdict.RTE})),
    "brute_force": Demand(_ALL - {Verdict.WA}, frozenset({Verdict.RTE, Verdict.TLE})),
}


def own_submissions(package: Package, folder: str = "") -> list[Own]:
    """The package's own submissions, all or those of a folder, in order of folder and name.

    Raises ProblemError for a link that leads out of the package, and for patterns that are none.
    """
    opened, found = package.opened, []
    patterns = _patterns(package)
    for each in opened.entries(FOLDER):
        if not each.is_dir() or (folder and each.name != folder):
            continue
        for path in opened.entries(FOLDER, each.name):
            opened.check(path)
            if path.stem.upper() != "README":
                demands = _demands(package, each.name, path.name, patterns)
                found.append(Own(path, opened.name_of(path), each.name, demands))
    return found


def tagged(own: Own, files: Content) -> Own:
    """With what a tag in the source says instead of the folder's name, where there is one."""
    for _, content in files:
        found = _TAG.search(content)
        if found:
            said = (word.strip().upper().replace("_", "-") for word in found[1].decode().split(","))
            verdicts = frozenset(_WORDS[word] for word in said if word in _WORDS)
            if verdicts:
                return Own(own.path, own.name, own.folder, (Demand(final=verdicts),))
    return own


def _demands(package: Package, folder: str, name: str, patterns: dict[str, Demand]) -> tuple[Demand, ...]:
    if package.form == LEGACY:
        verdict = _LEGACY_FOLDERS.get(folder)
        return (Demand(final=frozenset({verdict})),) if verdict else ()
    usual = patterns.get(folder) or _NEW_FOLDERS.get(folder)
    path = PurePosixPath(folder, name)
    more = (demand for pattern, demand in patterns.items() if pattern != folder and _matches(pattern, path))
    return (*([usual] if usual else []), *more)


def _patterns(package: Package) -> dict[str, Demand]:
    """What submissions.yaml demands, by pattern."""
    path = package.opened.root / FOLDER / _PATTERNS
    if package.form == LEGACY or not path.is_file():
        return {}
    where = package.opened.name_of(path)
    said = read_settings(package.opened, path)
    found = {}
    for pattern in said:
        about = section(said, pattern, where)
        unknown = set(about) - _LOOKED_AT - _NO_MATTER
        if unknown:
            what = f"{pattern[:60]}: {min(map(str, unknown))[:40]} is not looked at here"
            raise ProblemError(what, where=where, remedy="name files instead of --all")
        if not _LOOKED_AT.isdisjoint(about):
            found[pattern] = _demand(about, _NEW_FOLDERS.get(pattern, Demand()), where)
    return found


def _demand(about: Settings, usual: Demand, where: str) -> Demand:
    return Demand(
        _verdicts(about, "permitted", usual.permitted, where),
        _verdicts(about, "required", usual.required, where),
    )


def _verdicts(about: Settings, key: str, usual: frozenset[Verdict], where: str) -> frozenset[Verdict]:
    if about.get(key) is None:
        return usual
    names = words(about[key], key, where)
    known = {verdict.value for verdict in _ALL}
    if not set(names) <= known:
        raise ProblemError(f"{key} holds other words than {', '.join(sorted(known))}", where=where)
    return frozenset(map(Verdict, names))


def _matches(pattern: str, path: PurePosixPath) -> bool:
    """Whether a pattern names that path or a folder above it."""
    return any(_is(each.split("/"), path.parts) for each in _ways(pattern))


def _is(parts: list[str], path: tuple[str, ...]) -> bool:
    return len(parts) <= len(path) and all(map(fnmatchcase, path, parts))


def _ways(pattern: str) -> Iterator[str]:
    """The patterns without braces that one with braces stands for."""
    waiting, done = [pattern[:1000]], 0
    while waiting and done < _MOST_WAYS:
        each = waiting.pop()
        found = _BRACES.search(each)
        if found is None:
            done += 1
            yield each
        else:
            choices = found[1].split(",")[:_MOST_WAYS]
            waiting += [each[: found.start()] + choice + each[found.end() :] for choice in choices]
            del waiting[_MOST_WAYS:]
