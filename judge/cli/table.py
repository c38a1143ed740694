"""The table of commands: what each does, what a person wants to do with it, and where the manual tells more.

The command itself is `judge.cli.commands.<name>.command`; nothing is imported to list it.
"""

from __future__ import annotations

# command -> its sentence, the page of the manual that tells more; the first ten by what a person wants to do
_FIRST = {
    "To practise": {
        "init": ("Begin a kata: write the file for your solution.", "katas"),
        "run": ("Judge submissions on a problem.", "failure"),
        "watch": ("Judge a file again on every save.", "katas"),
        "hint": ("Give the next hint.", "katas"),
        "solution": ("Explain a model solution.", "katas"),
        "next": ("Go on to the next kata.", "katas"),
        "progress": ("Tick off the skills that your runs have shown.", "katas"),
    },
    "To look around": {
        "list": ("List the problems.", "answers"),
        "show": ("Show a problem: its statement, parameters and test groups.", "answers"),
        "help": ("Read the manual, or search it.", "commands"),
    },
}
_FURTHER = {
    "why": ("Say what the test groups probe, and which mistakes they should catch.", "failure"),
    "replay": ("Judge a submission on one case, by its replay id.", "failure"),
    "stress": (
        "Judge a submission on fresh cases until the time is up or something breaks.",
        "failure",
    ),
    "practice": ("Go through a set of katas in order.", "katas"),
    "due": ("Say what to do again today.", "katas"),
    "history": ("Show the runs so far.", "privacy"),
    "diff": ("Show what changed from one run to another.", "privacy"),
    "report": ("Write the history as one HTML page.", "privacy"),
    "new": ("Write a kata of your own to begin with.", "new-kata"),
    "verify": ("Check problems from the setter's side.", "problem-toml"),
    "data": ("Write a problem's test data and exact answers as files.", "problem-toml"),
    "doctor": ("Say how well submissions are contained on this machine.", "containment"),
    "schema": ("Print the JSON Schema of what a command writes with --json.", "scripts"),
    "completion": ("Print the script that lets a shell complete judge's words.", "scripts"),
}

# name -> what `judge --help` says of it
COMMANDS = {name: sentence for rows in (*_FIRST.values(), _FURTHER) for name, (sentence, _) in rows.items()}
TOPICS = {name: topic for rows in (*_FIRST.values(), _FURTHER) for name, (_, topic) in rows.items()}
FIRST = {aim: [(name, sentence) for name, (sentence, _) in rows.items()] for aim, rows in _FIRST.items()}
FURTHER = tuple(_FURTHER)
