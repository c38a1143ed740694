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


# heading of `judge --help` -> its commands; the last two are only named there
HEADINGS: Mapping[str, Mapping[str, Entry]] = {
    "Practise": {
        "start": Entry(
            "Start or resume a kata, and judge it on every save.",
            "start",
            "start",
            ("judge start", "judge start count --no-watch"),
        ),
        "run": Entry(
            "Judge submissions on a problem.",
            "failures",
            "run",
            (
                "judge run",
                "judge run count.py",
                "judge run count count.py --level interview",
            ),
        ),
        "hint": Entry(
            "Give the next hint.",
            "start",
            "hint",
            (
                "judge hint",
                "judge hint count --step 2",
            ),
        ),
        "solution": Entry(
            "Explain a model solution.",
            "start",
            "solution",
            (
                "judge solution",
                "judge solution count --give-up",
            ),
        ),
        "progress": Entry(
            "Show what you can do so far.",
            "start",
            "progress",
            (
                "judge progress",
                "judge progress junior",
                "judge progress --question Q7",
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
            "Show the runs so far.",
            "privacy",
            "history",
            (
                "judge history count --limit 5",
                "judge history --restore 3",
            ),
        ),
        "try": Entry(
            "Answer a case of your own, exactly.",
            "failures",
            "try",
            (
                'judge try count "0, 0, 1, (-1, 1), (1, 1)"',
                'judge try count "0 0 1 -1 1 1 1" count.py',
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
            "Ask cards, or hold a mock interview.",
            "interview",
            "quiz",
            (
                "judge quiz middle --cards 5",
                "judge quiz --row Q6",
                "judge quiz --interview --minutes 20",
            ),
        ),
        "hack": Entry(
            "Break a wrong program with one case.",
            "interview",
            "hack",
            (
                "judge hack count",
                'judge hack count 1 "0, 0, 1, (-1, 1), (1, 1)"',
                "judge hack count --list",
            ),
        ),
    },
    "Teach and set": {
        "class": Entry(
            "Judge what a class has handed in.",
            "class",
            "class",
            (
                "judge class homework -j 4",
                "judge class homework --students students.csv --json",
                "judge class homework --shard 3/20",
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
    "Also": {
        "due": Entry("Say what to do again today.", "start", "due", ("judge due",)),
        "report": Entry(
            "Write the history as one HTML page.",
            "privacy",
            "report",
            ("judge report --out me.html --name Ada",),
        ),
        "replay": Entry(
            "Judge a submission on one case, by its replay id.",
            "failures",
            "replay",
            ("judge replay count:grid:v0,0,2e-06,0,2e-06,8e-05,0:32a6be count.py",),
        ),
        "stress": Entry(
            "Judge a submission on fresh cases until the time is up or something breaks.",
            "failures",
            "stress",
            ("judge stress count.py --for 30s",),
        ),
        "explore": Entry(
            "Write a page on which a case can be moved about.",
            "failures",
            "explore",
            (
                "judge explore chord --open",
                'judge explore count "0, 0, 1, (-1, 1), (1, 1)"',
            ),
        ),
    },
}
COMMANDS: Mapping[str, Entry] = {name: entry for rows in HEADINGS.values() for name, entry in rows.items()}

# what a command was called -> the words that stand for it now
OLD: Mapping[str, tuple[str, ...]] = {
    "init": ("start", "--no-watch"),
    "watch": ("start",),
    "next": ("start",),
    "practice": ("list",),
    "why": ("show", "--groups"),
    "data": ("export", "--format", "files"),
    "schema": ("help", "--schema"),
    "completion": ("help", "--completion"),
}

# words that people try -> the command that they mean, where no name is near
LIKE: Mapping[str, str] = {"submit": "run", "test": "run", "check": "run", "judge": "run"}
