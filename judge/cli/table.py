"""The commands: what each does, where its function is, which page of the manual says more, what to type.

Nothing is imported to list them: a command is the one of that name in judge/cli/commands/MODULE.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Entry(NamedTuple):
    """A command: its sentence, the page of the manual, the module, and examples, one a line."""

    sentence: str
    topic: str
    module: str
    examples: tuple[str, ...]


# heading of `judge --help` -> its commands; the last ones are only named there
HEADINGS: Mapping[str, Mapping[str, Entry]] = {
    "Practise": {
        "start": Entry(
            "Start or resume a kata, and judge it on every save.",
            "start",
            "start",
            ("judge start", "judge start count --no-watch"),
        ),
        "run": Entry(
            "Judge files once.",
            "failures",
            "run",
            (
                "judge run",
                "judge run count.py --level interview",
                "judge run count.py --fresh 30s",
            ),
        ),
        "hint": Entry(
            "Give one more hint.",
            "start",
            "solution",
            (
                "judge hint",
                "judge hint count --step 2",
            ),
        ),
        "solution": Entry(
            "Show the model solution, and why it works.",
            "start",
            "solution",
            (
                "judge solution",
                "judge solution count --give-up",
                "judge solution count --times",
            ),
        ),
        "progress": Entry(
            "Show what you can do, what is due, and what comes next.",
            "start",
            "progress",
            (
                "judge progress",
                "judge progress junior",
                "judge progress --due",
                "judge progress --html --name Ada",
            ),
        ),
    },
    "Look": {
        "list": Entry(
            "List the katas by set.",
            "start",
            "look",
            (
                "judge list",
                "judge list middle --todo",
            ),
        ),
        "show": Entry(
            "Show a kata: its statement, its examples and what it allows.",
            "start",
            "look",
            (
                "judge show count",
                "judge show count --groups",
            ),
        ),
        "history": Entry(
            "Show your runs, one run, or what changed between two.",
            "privacy",
            "history",
            (
                "judge history count --limit 5",
                "judge history 3 5",
                "judge history 3 --restore",
            ),
        ),
        "try": Entry(
            "See the exact answer to one case, and what your file answers.",
            "failures",
            "cases",
            (
                "judge try",
                'judge try count "0, 0, 1, (-1, 1), (1, 1)" count.py',
                "judge try chord --open",
            ),
        ),
        "help": Entry(
            "Read the manual, or search it.",
            "start",
            "help",
            ("judge help interview", "judge help tolerance zero", "judge help --schema run"),
        ),
    },
    "Interview": {
        "quiz": Entry(
            "Ask short questions that need no code.",
            "interview",
            "quiz",
            ("judge quiz", "judge quiz middle --cards 5", "judge quiz --question Q6"),
        ),
        "interview": Entry(
            "Hold a mock interview.",
            "interview",
            "interview",
            ("judge interview", "judge interview senior --minutes 45", "judge interview --kata count"),
        ),
        "hack": Entry(
            "Find a case on which a wrong program fails.",
            "interview",
            "cases",
            (
                "judge hack count",
                'judge hack count 1 "0, 0, 1, (-1, 1), (1, 1)"',
                "judge hack count --list",
            ),
        ),
    },
    "Teach and set": {
        "class": Entry(
            "Judge everything that a class has submitted.",
            "class",
            "class",
            (
                "judge class homework -j 4",
                "judge class homework --students students.csv --csv grades.csv",
                "judge class homework count --html class.html --feedback pages",
            ),
        ),
        "new": Entry(
            "Write a kata of your own to begin with.", "new-kata", "setter", ("judge new . two-points",)
        ),
        "verify": Entry(
            "Check katas from the setter's side.",
            "problem",
            "setter",
            ("judge verify count --matrix", "judge verify --problems problems two-points"),
        ),
        "export": Entry(
            "Write katas as packages or files that other judges read.",
            "packages",
            "setter",
            (
                "judge export count --out packages",
                "judge export count --format files --out data",
                "judge export exact-count --out packages --version legacy --zip --wrong 5",
            ),
        ),
        "doctor": Entry(
            "Say how well submissions are contained on this machine.",
            "sandbox",
            "doctor",
            ("judge doctor", "judge doctor --languages"),
        ),
    },
}
COMMANDS: Mapping[str, Entry] = {name: entry for rows in HEADINGS.values() for name, entry in rows.items()}

# what a command was called -> the words that stand for it now
OLD: Mapping[str, tuple[str, ...]] = {
    "stress": ("run", "--fresh", "30s"),
    "bench": ("solution", "--times"),
    "due": ("progress", "--due"),
    "report": ("progress", "--html"),
    "init": ("start", "--no-watch"),
    "watch": ("start",),
    "next": ("start",),
    "practice": ("list",),
    "why": ("show", "--groups"),
    "data": ("export", "--format", "files"),
    "replay": ("try",),
    "explore": ("try", "--out", "judge-try.html"),
    "schema": ("help", "--schema"),
    "completion": ("help", "--completion"),
}

# an option that is gone -> what does its work now
GONE: Mapping[str, str] = {
    "--save-regression": "judge try --pytest FILE adds the last failing case as a test"
}

# words that people try -> the command that they mean, where no name is near
LIKE: Mapping[str, str] = {
    **dict.fromkeys(("submit", "test", "check", "judge"), "run"),
    "reset": "start --reset",
}
