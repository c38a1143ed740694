"""The commands: what each does, where its function is, which page of the manual says more, what to type.

Nothing is imported to list them: a command is the one of that name in judge/cli/commands/MODULE.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

# Headings of `judge --help`, the last one's commands only named there; a command, its module, its page of the
# manual and its sentence; and examples of it.
_TABLE = """
Practise
  start      practise   start      Start or resume a kata, and judge it on every save.
    judge start
    judge start count --no-watch
  run        run        failures   Judge files once.
    judge run
    judge run count.py --level interview
    judge run count.py --fresh 30s
  hint       practise   start      Give one more hint.
    judge hint
    judge hint count --step 2
  solution   practise   start      Show the model solution, and why it works.
    judge solution
    judge solution count --give-up
    judge solution count --times
  progress   progress   start      Show what you can do, what is due, and what comes next.
    judge progress
    judge progress junior
    judge progress --due
Look
  list       look       start      List the katas by set.
    judge list
    judge list middle --todo
  show       look       start      Show a kata: its statement, its examples and what it allows.
    judge show count
    judge show count --groups
  history    progress   privacy    Show your runs, or one run.
    judge history count --limit 5
    judge history 3
    judge history 3 --restore
  try        cases      failures   See the exact answer to one case, and what your file answers.
    judge try
    judge try count "0, 0, 1, (-1, 1), (1, 1)" count.py
    judge try chord --open
  help       look       start      Read the manual, or search it.
    judge help interview
    judge help tolerance zero
    judge help --schema run
Interview
  drill      interview  interview  Plan an evening of practice, mostly of what you do not know yet.
    judge drill
    judge drill --json
  quiz       interview  interview  Ask short questions that need no code.
    judge quiz
    judge quiz middle --cards 5
    judge quiz clamp
  interview  interview  interview  Hold a mock interview.
    judge interview
    judge interview senior --minutes 45
    judge interview --kata count
  hack       cases      interview  Find a case on which a wrong program fails.
    judge hack count
    judge hack count 1 "0, 0, 1, (-1, 1), (1, 1)"
Teach and set
  class      class      class      Judge everything that a class has submitted.
    judge class homework -j 4
    judge class homework --students students.csv --csv grades.csv
    judge class homework count --html class.html --feedback pages
  new        setter     new-kata   Write a kata of your own to begin with.
    judge new . two-points
  verify     setter     problem    Check katas from the setter's side.
    judge verify count --matrix
    judge verify --problems problems two-points
  export     setter     packages   Write katas as packages or files that other judges read.
    judge export count --out packages
    judge export count --format files --out data
    judge export exact-count --out packages --version legacy --zip --wrong 5
  site       site       site       Write a site on which the katas are practised in a browser tab.
    judge site --open
    judge site count segment --out public
  doctor     doctor     sandbox    Say how well submissions are contained on this machine.
    judge doctor
    judge doctor --languages
"""


class Command(NamedTuple):
    """A command: its module, its page of the manual, its sentence, and examples, one a line."""

    module: str
    topic: str
    sentence: str
    examples: list[str]


HEADINGS: dict[str, dict[str, Command]] = {}
for _line in _TABLE.strip().splitlines():
    match len(_line) - len(_line.lstrip()):
        case 0:
            _rows = HEADINGS[_line] = {}
        case 2:
            _name, _module, _topic, _sentence = _line.split(maxsplit=3)
            _rows[_name] = Command(_module, _topic, _sentence, [])
        case _:
            _rows[_name].examples.append(_line.strip())
COMMANDS: Mapping[str, Command] = {name: entry for rows in HEADINGS.values() for name, entry in rows.items()}

# words that people try -> the command that they mean, where no name is near
LIKE: Mapping[str, str] = {
    **dict.fromkeys(("submit", "test", "check", "judge"), "run"),
    "reset": "start --reset",
    "explain": "hint",
}
