"""Problems with bad files, and the commands that read them.

The base is a shipped problem with a few cases a group, or one of the fixtures, beside the shipped. It, or
the sets and skills beside it, is changed in one to three ways; a problem.py only by a line at its end.
"""

from __future__ import annotations

import os
import random
import re
import shlex
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from mangle import mangled_bytes, mangled_text, pool
from runs import ROOT, Run
from tables import changed_table

_FIXTURES = ROOT / "tests" / "fixtures"
_PACKS = (ROOT, _FIXTURES / "pack", _FIXTURES)  # each with its problems and solutions
_MODULES = Path(__file__).parent / "odd" / "modules.txt"  # lines that a setter should not end a module with
_ACCEPTED, _WRONG = 2, 3  # programs of a problem that come along
_CASES = 3  # of a group
_SHARED = ("sets/path.toml", "sets/junior.toml", "skills.toml")
_OWN = (*["problem.toml"] * 3, *["statement.md"] * 2, "hints.md", "pins.json")

_DEEP = ("(" * 300 + "1" + ")" * 300, "-" * 3000 + "1", "9" * 5000, "0x" + "f" * 5000)
_CALLS = (*pool("calls"), *(f"({deep}, 1)" for deep in _DEEP))
_ANSWERS = (
    *(*pool("answers"), "9" * 5000, "0x" + "f" * 5000),
    *("[" * 150 + "]" * 150, "[" * 5000, "-" * 5000 + "1"),
)


@cache
def _base() -> dict[str, bytes]:
    """The files of the pack that is changed, by their place in it."""
    files: dict[str, bytes] = {}
    for pack in _PACKS:
        for folder in sorted((pack / "problems").iterdir()):
            if (folder / "problem.toml").is_file():
                programs = pack / "solutions" / folder.name
                chosen = [*folder.glob("*.*")]
                chosen += sorted(programs.glob("accepted/*.py"))[:_ACCEPTED]
                chosen += sorted(programs.glob("wrong/*.py"))[:_WRONG]
                files |= {path.relative_to(pack).as_posix(): path.read_bytes() for path in chosen}
    for name in _SHARED:
        files[f"problems/{name}"] = (ROOT / "problems" / name).read_bytes()
    for name in files:
        if name.endswith("problem.toml"):
            text = re.sub(rb"(?m)^count = \d+", b"count = %d" % _CASES, files[name])
            files[name] = re.sub(rb"(?m)^(function|program) = .*", rb'\1 = "exact.py"', text)
        if name.endswith("problem.py"):
            files[name] = re.sub(rb"cases=\d+", b"cases=%d" % _CASES, files[name])
    return files


def prepare(chance: random.Random, folder: Path) -> tuple[list[str], list[Run]]:
    """Write a changed pack into the folder; what was changed, and the command lines that read it."""
    problem = chance.choice(sorted({name.split("/")[1] for name in _base() if name.endswith("problem.toml")}))
    files = {
        name: content for name, content in _base().items() if name.split("/")[1] == problem or _shared(name)
    }
    story: list[str] = []
    links: dict[str, str] = {}
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        name = _target(chance, files, problem)
        if chance.random() < 0.06:
            links[name] = chance.choice(_PLACES)
            story.append(f"{name}: {links[name]}")
        else:
            what, files[name] = _changed(chance, name, files.get(name, b""))
            story.append(f"{name}: {what}")
    for name, content in files.items():
        if name not in links:
            _write(folder / name, content)
    for name, kind in links.items():
        _place(folder / name, kind, files.get(name, b""))
    return story, _runs(chance, problem, files)


def _shared(name: str) -> bool:
    return name.removeprefix("problems/") in _SHARED


def _target(chance: random.Random, files: dict[str, bytes], problem: str) -> str:
    """The file to change."""
    if chance.random() < 0.12:
        return f"problems/{chance.choice(_SHARED)}"
    programs = [name for name in files if name.startswith(f"solutions/{problem}/")]
    if programs and chance.random() < 0.15:
        return chance.choice(programs)
    if chance.random() < 0.1:
        return f"problems/{problem}/problem.py"
    return f"problems/{problem}/{chance.choice(_OWN)}"


def _changed(chance: random.Random, name: str, content: bytes) -> tuple[str, bytes]:
    if name.endswith("problem.py"):
        line = chance.choice(_MODULES.read_text(encoding="utf-8").splitlines())
        return line, content + f"\n{line}\n".encode()
    if chance.random() < 0.15:
        return mangled_bytes(chance, content)
    text = content.decode("utf-8", "surrogateescape")
    if name.endswith(".toml") and chance.random() < 0.9:
        what, text = changed_table(chance, text)
    elif name.endswith("statement.md") and chance.random() < 0.7:
        what, text = _other_example(chance, text)
    else:
        what, text = mangled_text(chance, text)
    return what, text.encode("utf-8", "surrogateescape")


def _other_example(chance: random.Random, text: str) -> tuple[str, str]:
    """Another call or another answer in one of the worked examples."""
    found = list(re.finditer(r"^(\s*)>>> (\w+)(\(.*\))\n(.*)$", text, re.MULTILINE))
    if not found:
        return mangled_text(chance, text)
    one = chance.choice(found)
    call, answer = one[3], one[4].strip()
    if chance.random() < 0.5:
        call = chance.choice(_CALLS)
    else:
        answer = chance.choice(_ANSWERS)
    example = f"{one[1]}>>> {one[2]}{call}\n{one[1]}{answer}"
    return f"{one[2]}{call[:60]} → {answer[:60]}", text[: one.start()] + example + text[one.end() :]


_PLACES = (
    "nothing there",
    "a folder",
    "a link to nothing",
    "a link to itself",
    "a link to the file",
    "a pipe",
)


def _place(path: Path, kind: str, content: bytes) -> None:
    """Put something else where a file is meant."""
    path.parent.mkdir(parents=True, exist_ok=True)
    match kind:
        case "a folder":
            path.mkdir()
        case "a link to nothing":
            path.symlink_to("gone")
        case "a link to itself":
            path.symlink_to(path.name)
        case "a link to the file":
            elsewhere = path.with_name(f"elsewhere-{path.name}.txt")
            _write(elsewhere, content)
            path.symlink_to(elsewhere.name)
        case "a pipe":
            os.mkfifo(path)


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


_CHEAP = (
    *("list", "show {problem}", "show {problem} --groups", "start {problem} --no-watch", "hint {problem}"),
    *("hint {problem} --all", "progress", "progress junior"),
    *("solution {problem} --give-up", "progress --due"),
)
_DEAR = (
    *("export {problem} --out data", "run {problem} {program}", "verify {problem} --matrix"),
    *("run {problem} {program} --group {group} --seed 7", "verify {problem} --pin"),
    *("run {problem} {program} --fresh 0.05s --seed 7", "try {problem} '1 2' {program}"),
    "try {problem}:{group}:v1,2:000000 {program}",
)


def _commands(texts: Sequence[str], problem: str, group: str, program: str) -> list[tuple[str, ...]]:
    given = {"problem": problem, "group": group, "program": program}
    return [tuple(word.format(**given) for word in shlex.split(text)) for text in texts]


def _runs(chance: random.Random, problem: str, files: dict[str, bytes]) -> list[Run]:
    """Two to four commands that read the problem."""
    programs = [name for name in files if name.startswith(f"solutions/{problem}/")]
    program = f"../{chance.choice(programs)}"
    written = b"".join(_base()[f"problems/{problem}/problem.{kind}"] for kind in ("toml", "py")).decode()
    group = chance.choice([*re.findall(r'(?m)(?:^name = |group\()"([\w-]+)"', written), "examples"])
    cheap, dear = (_commands(texts, problem, group, program) for texts in (_CHEAP, _DEAR))
    chosen = [
        *chance.sample(cheap, chance.choice((1, 1, 2))),
        *chance.sample(dear, chance.choice((0, 0, 0, 1))),
    ]
    return [_run(chance, words) for words in chosen]


def _run(chance: random.Random, words: tuple[str, ...]) -> Run:
    checked = chance.random() < 0.5
    settings = {"JUDGE_PROBLEMS": "../problems"}
    width = chance.choice((None, None, "20", "47", "200"))
    if width:
        settings["COLUMNS"] = width
    return Run((words[0], "--json", *words[1:]) if checked else words, settings, checked=checked)
