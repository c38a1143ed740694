"""One output held against one test file: by the default output validator, or by the package's own."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError
from judge.packs.foreign.cases import DataFile
from judge.packs.foreign.opening import Opened
from judge.packs.foreign.package import Package
from judge.packs.foreign.programs import Content, NotRunError, program_of, validator_box
from judge.packs.foreign.tokens import BadFlagsError, difference, rules_of
from judge.problem.verdict import Verdict
from judge.sandbox.boundary import Stop, Usage
from judge.sandbox.factory import Boxes
from judge.sandbox.tool import Left, ToolBox

_RIGHT, _WRONG = 42, 43
_MESSAGE, _SCORE = "judgemessage.txt", "score.txt"
_SAID = 2000  # characters of the judge message
_MOST_FILES, _MOST_BYTES = 200, 64 << 20  # of a program
_ENDED = (Stop.ANSWERED, Stop.EXITED)
_HANGS = (Stop.CPU, Stop.WALL, Stop.WAITING)
_IDLE_SECONDS, _IDLE_SHARE = 60.0, 16.0  # that a validator may wait in all, and more for each second of work


class Checked(Struct, frozen=True):
    """AC, WA or JE; `message` says why, `told` is what a validator wrote for the jury."""

    verdict: Verdict
    message: str = ""
    told: str = ""


class Checker:
    """A context manager; a package's own validator is compiled on entering.

    `hung` says of a validator that took too long on one test file, or waited too long on all of them, which
    and where; nothing more is to be judged then.

    Raises:
        ProblemError: the validator does not compile, or is not run here.
        JudgeError: nothing can be run here.
    """

    def __init__(self, package: Package, boxes: Boxes) -> None:
        self._package = package
        self._boxes = boxes
        self._box: ToolBox | None = None
        self._used = Usage()
        self.hung = ""

    def __enter__(self) -> Checker:
        path = self._package.validator
        if path is not None:
            self._box = self._built(path)
        return self

    def __exit__(self, *exc: object) -> None:
        if self._box is not None:
            self._box.__exit__(*exc)

    def _built(self, path: Path) -> ToolBox:
        where = self._package.opened.name_of(path)
        try:
            program = program_of(where, content_of(self._package.opened, path))
        except NotRunError as fault:
            raise ProblemError(f"the output validator is not run: {fault}", where=where) from None
        box = validator_box(program, self._boxes)
        with box:
            wrong = box.inspect().fault
        if wrong:
            line = f" (line {wrong.line})" if wrong.line else ""
            raise ProblemError(f"the output validator does not compile: {wrong.message}{line}", where=where)
        return box

    def checked(self, test: DataFile, given: bytes, answer: bytes, output: bytes) -> Checked:
        """What an output to that test file is; `given` and `answer` are the file's."""
        if self._box is None:
            return _by_tokens(test, answer, output)
        files = [("test.in", given), ("test.ans", answer)]
        left = self._box.check(output, files, test.flags, self._package.validating)
        self._look_at_time(left, test)
        return Checked(Verdict.JE, self.hung) if self.hung else _by_validator(left)

    def _look_at_time(self, left: Left, test: DataFile) -> None:
        """Find out whether the validator hangs."""
        self._used += left.run.usage
        why = left.run.detail if left.run.stop in _HANGS else ""
        waited = self._used.waiting_seconds
        if waited > _IDLE_SECONDS + _IDLE_SHARE * self._used.cpu_seconds:
            why = why or f"has waited {waited:.0f} s in all"
        path = self._package.validator
        if why and path is not None:
            name = self._package.opened.name_of(path)
            self.hung = f"the output validator {name} {why}, on {test.name}"


def content_of(opened: Opened, path: Path) -> Content:
    """The files of a program of the package: one, or all of a folder, by their names from there on.

    Raises ProblemError for one that leads out of the package, and for too much.
    """
    if not path.is_dir():
        return [(path.name, opened.read(path, _MOST_BYTES))]
    found: list[tuple[str, bytes]] = []
    left = _MOST_BYTES
    for each in opened.walk(path):
        if len(found) == _MOST_FILES:
            raise ProblemError(f"a program of more than {_MOST_FILES} files", where=opened.name_of(path))
        content = opened.read(each, left)
        left -= len(content)
        found.append((each.relative_to(path).as_posix(), content))
    return found


def _by_tokens(test: DataFile, answer: bytes, output: bytes) -> Checked:
    try:
        rules = rules_of(test.flags)
    except BadFlagsError as fault:
        return Checked(Verdict.JE, str(fault))
    why = difference(answer, output, rules)
    return Checked(Verdict.WA, why) if why else Checked(Verdict.AC)


def _by_validator(left: Left) -> Checked:
    """What the output validator says; whatever it does not say by its exit status is a fault of its own."""
    run, files = left.run, dict(left.files)
    told = files.get(_MESSAGE, b"")[: 4 * _SAID].decode(errors="replace").strip()[:_SAID]
    if run.stop not in _ENDED or run.code is None:
        return Checked(Verdict.JE, f"the output validator {run.detail}", told)
    if run.code not in (_RIGHT, _WRONG):
        return Checked(Verdict.JE, f"the output validator ended with neither 42 nor 43: {_end(left)}", told)
    if left.why:
        return Checked(Verdict.JE, f"the output validator: {left.why}", told)
    if _SCORE in files:
        return Checked(Verdict.JE, f"the output validator wrote {_SCORE}, but no score is asked for", told)
    if run.code == _RIGHT:
        return Checked(Verdict.AC, "", told)
    return Checked(Verdict.WA, "the output validator rejects it", told)


def _end(left: Left) -> str:
    return left.run.detail or "exit status 0"
