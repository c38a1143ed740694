"""Folders of odd submissions, judged contained as any are: each has one result, and none costs another.

Among them are two that are right, the first and the last, and one that is wrong. The odd ones are made of

    odd/answers.txt   expressions, a line each; most are no answer to anything
    odd/classes.txt   the classes and functions that they name
    odd/shapes.txt    submissions around an answer, which ANSWER stands for, with `---` between them
    odd/lines.txt     whole submissions of one line; more are in odd/parts.toml
    odd/deeds.txt     what a hostile one does, `---` between them
    odd/moments.txt   when it does that, which is what `deed()` stands for; `first` comes before each answer

ENTRY stands for the function's name, ARGS for its parameters.
"""

from __future__ import annotations

import json
import random
import re
import textwrap
from functools import cache
from pathlib import Path

from mangle import mangled_bytes, mangled_text, pool
from runs import ROOT, Ended, Run

from judge.problem.load import load_problem

_BATCH = 6  # odd ones of a case, of which four are hostile
_LONGEST = 100_000  # characters of a result
_CASES = 2  # of a test group
_PROBLEMS = ("middle", "count", "segment", "ray-nearest", "exact-count")
_PACKS = {"middle": ROOT / "tests" / "fixtures" / "pack"}  # the others are shipped
_NAMES = (*(name.replace("<byte>", "\udcff") for name in pool("names")), "x" * 200)
_KNOWN = {"0-right.py": "AC", "1-wrong.py": "WA", "~right.py": "AC"}  # these are judged first and last
_IMPORTED = (
    *("atexit", "builtins", "gc", "json", "marshal", "mmap", "os", "random", "resource", "select", "signal"),
    *("subprocess", "sys", "threading", "time", "traceback", "warnings"),
)


_ODD = Path(__file__).with_name("odd")
_BETWEEN = "\n---\n"
_DEEP = "".join(f"{' ' * depth}if 1:\n" for depth in range(120)) + " " * 120 + "pass\n"
_WHOLE = (
    *(*pool("programs"), _DEEP, "(" * 500 + ")" * 500, "[" * 10_000, "-" * 50_000 + "1", "9" * 5000),
    *("x = " + "9" * 4000, "0x" + "f" * 10**5, "x = " + "1+" * 5000 + "1", "x = " + "f" * 10**5),
    *("x = '" + "a" * 10**6 + "'", "a = 1\n" * 50_000),
)


@cache
def _odd(name: str, between: str = "\n") -> tuple[str, ...]:
    """The parts of one of the files."""
    return tuple((_ODD / name).read_text(encoding="utf-8").removesuffix("\n").split(between))


def odd_program(chance: random.Random, entry: str, parameters: str) -> tuple[str, bytes]:
    """A program that nobody would write, and what it is."""
    if chance.random() < 0.3:
        text = chance.choice((*_WHOLE, *_odd("lines.txt")))
        what = repr(text[:60])
    else:
        shape, answer = chance.choice(_odd("shapes.txt", _BETWEEN)), chance.choice(_odd("answers.txt"))
        text = f"{_odd('classes.txt', chr(0))[0]}\n{shape.replace('ANSWER', f'({answer})')}\n"
        what = f"{shape[:90]!r} with {answer}"
    text = text.replace("ENTRY", entry).replace("ARGS", parameters)
    return what, text.encode("utf-8", "surrogatepass")


def hostile_program(chance: random.Random, entry: str, parameters: str) -> tuple[str, bytes]:
    """A program that does one to three hostile deeds, each at a moment of its own; else it answers."""
    text = f"import {', '.join(_IMPORTED)}\nkept, done = [], []\n{_odd('classes.txt', chr(0))[0]}\n"
    answer = chance.choice(("None", "1", "0.5", "[(1, 2)]"))
    story, befores = [], []
    for number in range(chance.choice((1, 1, 2, 3))):
        deed, moment = (
            chance.choice(_odd("deeds.txt", _BETWEEN)),
            chance.choice(_odd("moments.txt", _BETWEEN)),
        )
        body = textwrap.indent(deed, "    ")
        text += f"def deed{number}():\n{body}\n"
        text += re.sub(r"\b(deed|first|Odd|last|Last)\b", rf"\g<1>{number}", moment) + "\n"
        befores += [f"    found = first{number}()"] if "def first" in moment else []
        story.append(f"{deed[:60]!r} in {moment[:60]!r}")
    head = "def ENTRY(ARGS):" if chance.random() < 0.8 else "for line in sys.stdin:"  # or a whole program
    last = "return found or ANSWER" if head.startswith("def") else "print(found or ANSWER)"
    text += "\n".join([head, "    found = None", *befores, f"    {last}"])
    text = text.replace("ANSWER", answer).replace("ENTRY", entry).replace("ARGS", parameters)
    return ", ".join(story), f"{text}\n".encode()


def changed_program(chance: random.Random, source: bytes) -> tuple[str, bytes]:
    """A program changed in one to four places."""
    story = []
    for _ in range(chance.choice((1, 1, 2, 4))):
        if chance.random() < 0.3:
            what, source = mangled_bytes(chance, source)
        else:
            what, text = mangled_text(chance, source.decode("utf-8", "surrogateescape"))
            source = text.encode("utf-8", "surrogateescape")
        story.append(what)
    return ", ".join(story), source


@cache
def _files() -> dict[str, bytes]:
    """The pack: every problem with few cases and short limits, its hints left out."""
    files = {}
    for problem in _PROBLEMS:
        pack = _PACKS.get(problem, ROOT)
        folder = pack / "problems" / problem
        files |= {
            f"problems/{problem}/{name}": (folder / name).read_bytes()
            for name in ("problem.py", "statement.md")
        }
        files[f"problems/{problem}/problem.toml"] = _shortened(
            (folder / "problem.toml").read_text(encoding="utf-8")
        )
        for path in [*(pack / "solutions" / problem).glob("*/*.py")]:
            files[path.relative_to(pack).as_posix()] = path.read_bytes()
    return files


def _shortened(text: str) -> bytes:
    """A problem.toml with few cases, no race against a reference and a tenth of a second a group."""
    text = re.sub(r"(?m)^count = \d+", f"count = {_CASES}", text)
    text = re.sub(r"(?m)^cpu_seconds = .*", "cpu_seconds = 0.1", text)
    text = re.sub(r"(?m)^wall_seconds = .*", "wall_seconds = 1", text)
    return re.sub(r"(?m)^\[time(\.\w+)?\].*\n([^\[\n].*\n|\n)*", "", text).encode()


def prepare(chance: random.Random, folder: Path) -> tuple[list[str], list[Run]]:
    """Write a folder of submissions; the command line that judges them."""
    for name, content in _files().items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    problem = chance.choice(_PROBLEMS)
    shipped = load_problem(folder / "problems" / problem)
    entry, parameters = shipped.entry, ", ".join(parameter.name for parameter in shipped.parameters)
    batch = folder / "work" / "batch"
    batch.mkdir(parents=True)
    wrong = f"def {entry}({parameters}):\n    return 'wrong'\n".encode()
    for name, verdict in _KNOWN.items():
        (batch / name).write_bytes(_program(problem, "accepted", entry) if verdict == "AC" else wrong)
    story = [f"{problem}"]
    for number in range(_BATCH):
        if number % 3:
            what, source = hostile_program(chance, entry, parameters)
        elif chance.random() < 0.5:
            what, source = odd_program(chance, entry, parameters)
        else:
            source = chance.choice(
                [content for name, content in _files().items() if name.startswith(f"solutions/{problem}/")]
            )
            what, source = changed_program(chance, source)
        name = f"odd{number}.py" if chance.random() < 0.7 else f"{chance.choice(_NAMES)}{number}.py"
        (batch / name).write_bytes(source)
        story.append(f"{name!r}: {what}")
    return story, _runs(chance, problem, [group.name for group in shipped.groups])


def _program(problem: str, folder: str, entry: str) -> bytes:
    """The first solution in that folder that defines the entry."""
    start = f"solutions/{problem}/{folder}/"
    return next(
        content
        for name, content in sorted(_files().items())
        if name.startswith(start) and f"def {entry}(".encode() in content
    )


def _runs(chance: random.Random, problem: str, groups: list[str]) -> list[Run]:
    """All of them judged, most often; else one of them stressed."""
    few = ("--group", groups[0], "--group", chance.choice(groups[1:]))
    level = ("--isolation", "strong") if chance.random() < 0.1 else ()
    if chance.random() < 0.1:
        name = f"batch/odd{chance.randrange(_BATCH)}.py"
        stressing = ("run", problem, name, "--json", "--fresh", "0.2s", "--seed", "7", *few, *level)
        return [_one(stressing)]
    words = ["run", problem, "batch", *few, *level]
    words += ["--no-shrink"] if chance.random() < 0.7 else []
    words += ["--no-name"] if chance.random() < 0.92 else []  # else the known mistakes are judged too
    words += ["-j", "2"] if chance.random() < 0.3 else []
    words += ["--junit", "out.xml"] if chance.random() < 0.3 else []
    form = chance.choice(("--json", "--json", "--json", "--format=github", "--format=text", "-q"))
    return [_one((words[0], form, *words[1:]))]


def _one(words: tuple[str, ...], interrupt: float | None = None) -> Run:
    settings = {"JUDGE_PROBLEMS": "../problems", "COLUMNS": "80"}
    return Run(words, settings, checked="--json" in words, interrupt=interrupt)


def further_faults(run: Run, ended: Ended, folder: Path) -> list[str]:
    """What is wrong with the results: one is missing, is the judge's fault, or is not what it must be."""
    if run.words[:2] != ("run", "--json"):
        return ["the judge is at fault"] if ended.status == 3 and "--fresh" not in run.words else []
    results = [json.loads(line) for line in ended.out.split("\n")[:-1]]
    batch = (folder / "work" / "batch").iterdir()
    given = sum(not path.name.startswith((".", "__")) for path in batch)  # others are hidden
    found = [] if len(results) == given else [f"it has {len(results)} results of {given} submissions"]
    known = {result["submission"].rpartition("/")[2]: result for result in results}
    for name, result in known.items():
        why = str((result["failure"] or {}).get("message"))
        wanted = _KNOWN.get(name)
        if result["verdict"] == "JE" or wanted not in (None, result["verdict"]):
            found.append(f"{name!r} is judged {result['verdict']}, not {wanted or 'by itself'}: {why[:300]}")
        if len(json.dumps(result)) > _LONGEST:
            found.append(f"the result of {name!r} has {len(json.dumps(result))} characters")
    return found
