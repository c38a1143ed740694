"""The table of commands: what each does, what a person wants to do with it, and where the manual tells more.

The command itself is `judge.cli.commands.<name>.command`; nothing is imported to list it.
"""

from __future__ import annotations

from collections.abc import Mapping

# command -> its sentence, the page of the manual that tells more; the first ten by what a person wants to do
_FIRST = {
    "To practise": {
        "init": ("Begin a kata: write the file for your solution.", "start"),
        "run": ("Judge submissions on a problem.", "failures"),
        "watch": ("Judge a file again on every save.", "start"),
        "hint": ("Give the next hint.", "start"),
        "solution": ("Explain a model solution.", "start"),
        "next": ("Go on to the next kata.", "start"),
        "progress": ("Show what you can do so far.", "start"),
    },
    "To look around": {
        "list": ("List the problems.", "start"),
        "show": ("Show a problem: its statement, parameters and test groups.", "start"),
        "help": ("Read the manual, or search it.", "start"),
    },
}
_FURTHER = {
    "try": ("Answer a case of your own, exactly.", "failures"),
    "hack": ("Break a wrong program with one case.", "interview"),
    "explore": ("Write a page on which a case can be moved about.", "failures"),
    "replay": ("Judge a submission on one case, by its replay id.", "failures"),
    "stress": (
        "Judge a submission on fresh cases until the time is up or something breaks.",
        "failures",
    ),
    "class": ("Judge what a class has handed in.", "class"),
    "quiz": ("Ask cards, or hold a mock interview.", "interview"),
    "due": ("Say what to do again today.", "start"),
    "history": ("Show the runs so far.", "privacy"),
    "report": ("Write the history as one HTML page.", "privacy"),
    "new": ("Write a kata of your own to begin with.", "new-kata"),
    "verify": ("Check problems from the setter's side.", "new-kata"),
    "data": ("Write a problem's test data and exact answers as files.", "programs"),
    "export": ("Write problems as packages that other judges read.", "packages"),
    "doctor": ("Say how well submissions are contained on this machine.", "sandbox"),
    "schema": ("Print the JSON Schema of what a command writes with --json.", "scripts"),
}

# name -> what `judge --help` says of it
COMMANDS = {name: sentence for rows in (*_FIRST.values(), _FURTHER) for name, (sentence, _) in rows.items()}
TOPICS = {name: topic for rows in (*_FIRST.values(), _FURTHER) for name, (_, topic) in rows.items()}
FIRST = {aim: [(name, sentence) for name, (sentence, _) in rows.items()] for aim, rows in _FIRST.items()}
FURTHER = tuple(_FURTHER)

# name -> what to type, one thing a line: the end of each command's help
EXAMPLES: Mapping[str, tuple[str, ...]] = {
    "init": ("judge init count", "judge init count my-count.py"),
    "run": (
        "judge run",
        "judge run count.py",
        "judge run count count.py --level interview",
    ),
    "watch": ("judge watch", "judge watch count.py"),
    "hint": ("judge hint", "judge hint count --step 2"),
    "solution": ("judge solution", "judge solution count --give-up"),
    "next": ("judge next", "judge next --init"),
    "progress": ("judge progress", "judge progress junior", "judge progress --question Q7"),
    "list": ("judge list", "judge list --json"),
    "show": ("judge show count", "judge show count --groups"),
    "help": ("judge help interview", "judge help --search tolerance"),
    "try": (
        'judge try count "0, 0, 1, (-1, 1), (1, 1)"',
        'judge try count "0 0 1 -1 1 1 1" count.py',
    ),
    "hack": ("judge hack count", 'judge hack count 1 "0, 0, 1, (-1, 1), (1, 1)"', "judge hack count --list"),
    "explore": ("judge explore chord --open", 'judge explore count "0, 0, 1, (-1, 1), (1, 1)"'),
    "replay": ("judge replay count:grid:v0,0,2e-06,0,2e-06,8e-05,0:32a6be count.py",),
    "stress": ("judge stress count.py --for 30s",),
    "class": (
        "judge class homework -j 4",
        "judge class homework --students students.csv --json",
        "judge class homework --shard 3/20",
    ),
    "quiz": ("judge quiz middle --cards 5", "judge quiz --row Q6", "judge quiz --interview --minutes 20"),
    "due": ("judge due",),
    "history": ("judge history count --limit 5", "judge history --restore 3"),
    "report": ("judge report --out me.html --name Ada",),
    "new": ("judge new . two-points",),
    "verify": ("judge verify count", "judge verify --problems problems two-points"),
    "data": ("judge data count --out count-data",),
    "export": (
        "judge export count --out packages",
        "judge export exact-count --out packages --version legacy --zip --wrong 5",
    ),
    "doctor": ("judge doctor",),
    "schema": ("judge schema run",),
}
