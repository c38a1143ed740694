"""Transcripts: commands with what they show, as texts that are run again.

    # terminal 80x24               a terminal of that size reads; without it, a pipe
    # needs tests/fixtures/pack    this folder of the repository is copied beside the files
    # needs broken                 ../broken holds every broken problem of tests/broken_problems.py
    + one.py                       a file is written, into a copy of tests/golden/files,
    | def middle(a, b): return 1   with these lines
    $ judge run middle one.py      a command, in that copy
    < n                            a line that is typed
      WA  floor.py                 standard output, two characters to the right
    ! judge: no such file          standard error
    = 1                            the exit status, where it is not 0
    $ cat out.xml                  a file that was written

What differs from machine to machine is masked. To add a call, write its line and run
`python -m tests.transcripts --only NAME --write`.
"""

from __future__ import annotations

import io
import json
import os
import re
import shlex
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, chdir, contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

from broken_problems import FAULTS, broken
from jsonschema import Draft202012Validator
from jsonschema.exceptions import best_match

from judge import __version__
from judge.cli import main
from judge.cli.app import app
from judge.judging.containment import keep_level
from judge.sandbox.available import levels_here
from judge.schema import schema_of
from transcripts.steady import steadied

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "tests" / "golden" / "transcripts"
_FILES = ROOT / "tests" / "golden" / "files"
_PACK = ROOT / "tests" / "fixtures" / "pack"
_SETTINGS = (
    "NO_COLOR",
    "FORCE_COLOR",
    "COLUMNS",
    "LINES",
    "TERM",
    "JUDGE_PROBLEMS",
    "JUDGE_DB",
    "CI",
    "GITHUB_ACTIONS",
)
_NOISE = {  # keys of JSON whose values another machine, or another day, would have otherwise
    "cpu_seconds", "wall_seconds", "memory_bytes", "isolation", "low", "high", "median", "pairs", "at",
    "seconds", "judged_at", "worker", "machine", "python", "standard", "cases_per_second", "digest",
}  # fmt: skip
_MASKS = [  # of text, each as wide as what it hides, but for the first: somebody else is at work here
    (re.compile(r"judge: Waited: another judge of yours was timing\n"), ""),
    (re.compile(r"\d{4}-\d\d-\d\d"), "2026-01-01"),
    (re.compile(r"\b\d\d-\d\d \d\d:\d\d\b"), "01-01 00:00"),
    (re.compile(r"T\d\d:\d\d:\d\d(\.\d+)?(?=\+|Z)"), "T00:00:00"),
]


class Step(NamedTuple):
    """One command of a transcript: its words, and the lines that are typed.

    Its `kind` is `judge`, `cat` for a file that is shown, or `+` for one that is written with those lines.
    """

    kind: str
    words: str
    typed: str = ""


class Transcript(NamedTuple):
    """The commands of one file, and the terminal that reads them: columns and rows, or None for a pipe."""

    steps: tuple[Step, ...]
    terminal: tuple[int, int] | None
    needs: tuple[str, ...]
    head: str

    @classmethod
    def read(cls, text: str) -> Transcript:
        """The commands, without what they showed."""
        steps: list[Step] = []
        terminal, needs, head = None, [], []
        for line in text.splitlines():
            kind, _, words = line.removeprefix("$ ").partition(" ")
            if line.startswith(("$ judge", "$ cat ", "+ ")):
                steps.append(Step(kind, words.strip()))
            elif line.startswith(("< ", "|")):
                steps[-1] = steps[-1]._replace(typed=f"{steps[-1].typed}{line[2:]}\n")
            elif line.startswith("# ") and not steps:
                head.append(line)
                word, _, value = line[2:].partition(" ")
                if word == "terminal":
                    columns, _, rows = value.partition("x")
                    terminal = int(columns), int(rows)
                elif word == "needs":
                    needs.append(value)
        return cls(tuple(steps), terminal, tuple(needs), "\n".join(head))


def names() -> list[str]:
    """The transcripts, as names of their files: run/refused."""
    return sorted(str(path.relative_to(FOLDER).with_suffix("")) for path in FOLDER.rglob("*.txt"))


def path_of(name: str) -> Path:
    """The file of a transcript."""
    return FOLDER / f"{name}.txt"


def played(name: str, world: Path) -> str:
    """The transcript with what its commands show now; `world` holds what transcripts share.

    Raises AssertionError where JSON does not keep to its schema.
    """
    script = Transcript.read(path_of(name).read_text(encoding="utf-8"))
    parts = [script.head] if script.head else []
    world.mkdir(parents=True, exist_ok=True)
    with steadied(world.parent), _place(script, world):
        for step in script.steps:
            parts.append(_shown(step, script.terminal))
    return "\n".join(parts) + "\n"


@contextmanager
def _place(script: Transcript, world: Path) -> Iterator[None]:
    """A folder of the transcript's own, and nothing of this machine's settings."""
    here = world / "here"
    shutil.rmtree(here, ignore_errors=True)
    shutil.copytree(_FILES, here)
    for need in script.needs:
        if need == "broken":
            _broken(world / "broken")
        else:
            shutil.copytree(ROOT / need, here / Path(need).name)
    settings = dict.fromkeys(_SETTINGS, "") | {
        "JUDGE_PROBLEMS": str(_pack(world)),
        "JUDGE_DB": str(here / ".history.sqlite3"),
        "TERM": "xterm-256color",
        "NO_COLOR": "1",
    }
    if script.terminal:
        settings |= {"COLUMNS": str(script.terminal[0]), "LINES": str(script.terminal[1])}
    kept = {name: value for name, value in settings.items() if value}
    with ExitStack() as stack:
        stack.enter_context(patch.dict(os.environ, kept))
        for name in settings.keys() - kept.keys():
            os.environ.pop(name, None)
        stack.enter_context(chdir(here))
        yield


def _pack(world: Path) -> Path:
    """The pack of small problems, and a cache that knows this machine's isolation."""
    problems = world / "pack" / "problems"
    if not problems.exists():
        shutil.copytree(_PACK, world / "pack")
        keep_level(next(level.name for level in levels_here() if level.available))
    return problems


def _broken(folder: Path) -> None:
    """Every broken problem, in a folder that transcripts share."""
    if not folder.exists():
        folder.mkdir()
        for name in FAULTS:
            broken(name, folder)


class _Stream(io.TextIOWrapper):
    """A standard stream that says whether it is a terminal."""

    def __init__(self, text: str = "", *, terminal: bool = False) -> None:
        super().__init__(io.BytesIO(text.encode()), encoding="utf-8", write_through=True)
        self._terminal = terminal

    def isatty(self) -> bool:
        return self._terminal

    @property
    def text(self) -> str:
        return self.buffer.getvalue().decode()  # type: ignore[attr-defined]


def _shown(step: Step, terminal: tuple[int, int] | None) -> str:
    """A step with what it shows."""
    if step.kind == "judge":
        return _judged(step, terminal)
    if step.kind == "+":
        Path(step.words).parent.mkdir(parents=True, exist_ok=True)
        Path(step.words).write_text(step.typed, encoding="utf-8")
        return "\n".join([f"+ {step.words}", *(f"| {line}".rstrip() for line in step.typed.splitlines())])
    written = _masked(Path(step.words).read_text(encoding="utf-8"))
    return "\n".join([f"$ cat {step.words}", *(f"  {line}".rstrip() for line in written.splitlines())])


def _judged(step: Step, terminal: tuple[int, int] | None) -> str:
    """A command with what it shows."""
    out, err = _Stream(terminal=terminal is not None), _Stream()
    status = 0
    with (
        patch.object(sys, "argv", ["judge", *shlex.split(step.words)]),
        patch.object(sys, "stdin", _Stream(step.typed)),
        patch.object(sys, "stdout", out),
        patch.object(sys, "stderr", err),
        patch("secrets.randbits", return_value=1),  # of the figures of cards
    ):
        try:
            main()
        except SystemExit as end:
            status = int(end.code or 0)
    lines = [f"$ judge {step.words}".rstrip(), *(f"< {line}" for line in step.typed.splitlines())]
    written = out.text
    if "--json" in step.words:
        written = "\n".join(_checked(step, line) for line in written.splitlines())
    written = _masked(written)
    lines += [f"  {line}".rstrip() for line in written.splitlines()]
    lines += [f"! {line}".rstrip() for line in _masked(err.text).splitlines()]
    return "\n".join([*lines, *([f"= {status}"] if status else [])])


def _checked(step: Step, line: str) -> str:
    """A line of JSON, which keeps to its command's schema, without noise."""
    value = json.loads(line)
    if "--schema" in step.words:
        return json.dumps(value, ensure_ascii=False)
    fault = best_match(Draft202012Validator(_schema(step.words.split())).iter_errors(value))
    assert fault is None, f"judge {step.words}: {fault.json_path} {fault.message}"
    return json.dumps(_quiet(value), ensure_ascii=False)


def _schema(words: list[str]) -> dict[str, Any]:
    command = app.get_command(None, words[0])
    assert command is not None
    return schema_of(command)


def _quiet(value: Any, key: str = "") -> Any:
    """JSON without what differs from machine to machine."""
    if key in _NOISE and value is not None:
        return 0
    if isinstance(value, Mapping):
        return {name: _quiet(part, name) for name, part in value.items()}
    if isinstance(value, list):
        return [_quiet(part, key) for part in value]
    return value


def _masked(text: str) -> str:
    """Text without this machine's folders, today's date, the version and times."""
    folder = str(Path.cwd())
    for place, mask in ((folder, "."), (str(Path(folder).parent), ".."), (str(ROOT), "<judge>")):
        text = text.replace(place, mask)
    text = text.replace(f"isolation on {os.uname().nodename}", "isolation on <here>")
    for pattern, mask in _MASKS:
        text = pattern.sub(mask, text)
    return text.replace(__version__, "<version>").replace(str(Path.home()), "~")
