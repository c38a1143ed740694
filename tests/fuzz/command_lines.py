"""Odd command lines in odd worlds: every command and every option that the command line itself lists.

The words and the settings are in odd/words.toml. The current folder holds submissions and other files, under
good names and bad ones.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import sys
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import click
from runs import ROOT, Ended, Run
from worker import CLOSED, FULL, GONE, KEPT, NULL, TERMINAL

from judge.cli.app import app
from judge.cli.table import COMMANDS

sys.path.append(str(ROOT / "tests"))

_FIXTURES = ROOT / "tests" / "fixtures"
_BROKEN = "../broken"  # from where a command line is run
_STANDS_FOR = {"<byte>": "\udcff", "<long>": "x" * 5000, "<digits>": "9" * 5000, "<broken>": _BROKEN}
_UNSET = "<unset>"
_MEAN = b"def middle(a, b):\n    return (a + b) / 2\n"
_FLOOR = b"def middle(a, b):\n    return (a + b) // 2\n"
_FILES = {
    **dict.fromkeys(("mean.py", "team/mean.py", "homework/ada/middle.py"), _MEAN),
    **dict.fromkeys(("floor.py", "team/floor.py", "-dash.py", "no\udcffutf8.py", "spaced name.py"), _FLOOR),
    **dict.fromkeys(
        ("bad\nname.py", "\x1b[31mred.py", "\u202egnp.py", "::notice::x.py", "x" * 240 + ".py"), _FLOOR
    ),
    "raises.py": b"def middle(a, b):\n    return a / 0\n",
    "program.py": b"for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n",
    "bytes.py": b"\xff\xfe\0\0",
    "notes.txt": b"my own notes\n",
    "garbage": bytes(range(256)) * 20,
    "old.svg": b"<svg></svg>\n",
    "old.xml": b"<?xml version='1.0'?><testsuites/>\n",
    **dict.fromkeys(("empty", "empty.py"), b""),
}
_LINKS = {"link": "mean.py", "loop": "loop", "dangling": "gone", "full": "/dev/full", "zero": "/dev/zero"}
_LOCKED = {"unreadable.py": 0o000, "readonly.py": 0o400, "sealed": 0o000, "locked": 0o500}
_SHIPPED = ("count", "segment", "ray-nearest", "exact-count")


def prepare(chance: random.Random, folder: Path) -> tuple[list[str], list[Run]]:
    """Lay out the folder; one to three command lines, of which all but the last only leave a history."""
    _lay_out(folder)
    runs = []
    if chance.random() < 0.15:
        runs.append(_usual("run", "--json", "middle", "floor.py", "mean.py"))
    if chance.random() < 0.15:
        runs.append(_usual("start", "--json", "middle", "--no-watch"))
    odd = _odd(chance)
    if any(_BROKEN in (word or "") for word in (*odd.words, *odd.settings.values())):
        from broken_problems import FAULTS, broken  # late: there is no other way to a folder above

        for name in FAULTS:
            broken(name, folder / "broken")
    return [], [*runs, odd]


def _usual(*words: str) -> Run:
    return Run(words, {"JUDGE_PROBLEMS": "../problems"}, checked=True)


def _lay_out(folder: Path) -> None:
    shutil.copytree(_FIXTURES / "pack", folder, dirs_exist_ok=True)
    work = folder / "work"
    for name, source in _FILES.items():
        path = work / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(source)
    (work / "folder" / "inner").mkdir(parents=True)
    os.mkfifo(work / "pipe")
    for name, mode in _LOCKED.items():  # which binds nobody who is root
        (work / name).touch(mode) if name.endswith(".py") else (work / name).mkdir(mode)
    for name, target in _LINKS.items():
        (work / name).symlink_to(target)


@cache
def pool(table: str) -> dict[str, tuple[str, ...]]:
    """A table of odd/words.toml."""
    content = tomllib.loads((Path(__file__).parent / "odd" / "words.toml").read_text(encoding="utf-8"))
    return {name: tuple(map(_meant, words)) for name, words in content[table].items()}


def _meant(word: str) -> str:
    for written, text in _STANDS_FOR.items():
        word = word.replace(written, text)
    return word


def _odd(chance: random.Random) -> Run:
    """The command line in question."""
    words, command = _words(chance)
    settings, streams, extra = _world(chance)
    checked = False
    if command is not None and _takes_json(command) and chance.random() < 0.4:
        words = (words[0], "--json", *words[1:])
        checked = "_JUDGE_COMPLETE" not in settings and not {"--help", "-h"} & set(words)
    if words[:1] == ("verify",):  # the shipped problems take long, and have tests of their own
        words = (*(word for word in words if word not in _SHIPPED), "middle")
    waits = words[:1] == ("start",) or (words[:1] in (("quiz",), ("interview",)) and streams[0] == TERMINAL)
    if waits:
        extra["interrupt"] = 1.0
    return Run(words, {"JUDGE_PROBLEMS": "../problems"} | settings, streams, checked=checked, **extra)


def _words(chance: random.Random) -> tuple[tuple[str, ...], click.Command | None]:
    """The words, and the command that they name."""
    loose = pool("words")["LOOSE"]
    if chance.random() < 0.06:
        return tuple(chance.choice((*loose, *COMMANDS)) for _ in range(chance.randrange(4))), None
    name = chance.choice(list(COMMANDS))
    command = app.get_command(None, name)
    assert command is not None
    words: list[str] = []
    for parameter in command.params:
        words += (_option if isinstance(parameter, click.Option) else _argument)(chance, parameter)
    if chance.random() < 0.15:
        words.insert(chance.randint(0, len(words)), chance.choice(loose))
    if chance.random() < 0.1 and words:
        del words[chance.randrange(len(words))]
    if chance.random() < 0.05:
        chance.shuffle(words)
    return (name, *words), command


def _option(chance: random.Random, option: Any) -> list[str]:
    """The option with a value, several times, or most often not at all."""
    words: list[str] = []
    while option.name not in ("as_json", "json") and chance.random() < 0.22:
        name = chance.choice(option.opts)
        value = [] if option.is_flag else [_value(chance, option)]
        joined = value and name.startswith("--") and chance.random() < 0.3
        words += [f"{name}={value[0]}"] if joined else [name, *value]
    return words


def _argument(chance: random.Random, argument: Any) -> list[str]:
    if not argument.required and chance.random() < 0.25:
        return []
    several = chance.choice((1, 1, 2, 4)) if argument.nargs == -1 else 1
    values = [_value(chance, argument) for _ in range(several)]
    return ["mean.py" if value == "pipe" else value for value in values]  # a pipe is waited for


def kinds(parameter: click.Parameter) -> list[str]:
    """The tables of odd/words.toml that its values are in."""
    if isinstance(parameter.type, click.Choice) or getattr(parameter, "is_flag", False):
        return []
    return re.findall(r"[A-Z/]+", parameter.metavar or "N")


def _value(chance: random.Random, parameter: click.Parameter) -> str:
    """A value for it, a good one half of the time."""
    if isinstance(parameter.type, click.Choice):
        return chance.choice([*parameter.type.choices, "none-such"])
    values = pool("words")[chance.choice(kinds(parameter))]
    return chance.choice(values[:3] if chance.random() < 0.5 else values)


def _takes_json(command: click.Command) -> bool:
    return any("--json" in parameter.opts for parameter in command.params)


def _world(chance: random.Random) -> tuple[dict[str, str | None], tuple[str, str, str], dict[str, Any]]:
    """The environment, the streams and the rest."""
    settings: dict[str, str | None] = {}
    for name, values in pool("settings").items():
        if chance.random() < (0.02 if name == "_JUDGE_COMPLETE" else 0.07):
            value = chance.choice(values)
            settings[name] = None if value == _UNSET else value
    streams = (NULL, KEPT, KEPT)
    if chance.random() < 0.3:
        streams = (
            chance.choice((NULL, NULL, CLOSED, KEPT, TERMINAL)),
            chance.choice((KEPT, KEPT, CLOSED, FULL, GONE, TERMINAL, NULL)),
            chance.choice((KEPT, KEPT, KEPT, CLOSED, FULL, GONE, TERMINAL)),
        )
    extra: dict[str, Any] = {"typed": chance.choice(("", "y\n", "n\n", "\x04"))}
    if chance.random() < 0.04:
        extra |= {"gone": True, "folder": "away"}
    if chance.random() < 0.07:
        extra["encoding"] = chance.choice(("ascii", "latin-1", "cp1252"))
    return settings, streams, extra


def further_faults(run: Run, _ended: Ended, folder: Path) -> list[str]:
    """What the command line has done to files that it was not asked to change."""
    if "--force" in run.words:
        return []
    changed = [
        name
        for name, source in _FILES.items()
        if source not in (b"", _FILES["old.svg"], _FILES["old.xml"])
        and (folder / "work" / name).read_bytes() != source
    ]
    return [f"it changes {name!r}, which nobody asked for" for name in changed]
