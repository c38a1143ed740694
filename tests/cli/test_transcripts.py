"""Transcripts are as they were; and what holds of all: refusals, widths, the words of a topic."""

from __future__ import annotations

import re
import shutil
from typing import NamedTuple

import pytest
from sampling import nightly
from transcripts import play as transcripts

from judge.cli.table import COMMANDS

# What is said of circles and lines; a "line" of output is none of them.
TOPIC = re.compile(
    r"\b(circles?|rays?|tangents?|tangency|segments?|extents?|radius|radii|chords?|secants?|intersections?"
    r"|straight line|infinite line|lines? and circles?|circle-line|figure|e away)\b",
    re.IGNORECASE,
)
OWN = ("[circle; 1..6]", "Circle", '"extent": ')  # a kata's own type, and a key of [tolerance]
COPIED = re.compile(r"\bjudge \w+ |^  [\w-]+(/[\w.-]+)+$")  # a command or a path is never broken
ROWS = 23  # of a terminal's 24: the shell's prompt takes the last one


class Call(NamedTuple):
    """A command of a transcript, with what it wrote."""

    name: str
    words: str
    out: list[str]
    err: list[str]
    status: int


def calls(name: str) -> list[Call]:
    found: list[Call] = []
    for line in transcripts.path_of(name).read_text(encoding="utf-8").splitlines():
        if line.startswith("$ judge"):
            found.append(Call(name, line[8:], [], [], 0))
        elif line.startswith(("$ cat ", "+ ")):
            found.append(Call(name, "", [], [], 0))  # no command's
        elif found and line.startswith("! "):
            found[-1].err.append(line[2:])
        elif found and line.startswith("= "):
            found[-1] = found[-1]._replace(status=int(line[2:]))
        elif found and not line.startswith(("< ", "|", "# ")):
            found[-1].out.append(line[2:])
    return [call for call in found if call.words]


NAMES = transcripts.names()
CALLS = [call for name in NAMES for call in calls(name)]
SAID_BEFORE = ("Writing ", "judge: not judged: ", "judge: data is now: ")  # before the refusal


# Those that are played every day: one of each kind, and refusals and help, which are cheap.
WHOLE = ("help/", "refused/")
BY_DAY = {
    *("faults/run", "faults/history", "history/restore", "kata/init", "kata/hints", "quiz/own-decks"),
    *("json/history", "json/init", "json/try", "run/junit", "setter/looking"),
    *("screens/hack.80x24", "screens/run-cannot.80x24", "screens/run-several.80x24"),
    *("screens/run-wrong.80x24", "screens/list.80x24", "screens/show.80x24", "try/answers"),
}
NEEDS = {"screens/run-cpp": "g++"}  # a tool of this machine


def of_the_day(name: str) -> bool:
    return name in BY_DAY or name.startswith(WHOLE)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name if of_the_day(name) else nightly(name) for name in NAMES])
def test_a_transcript_is_as_it_was(name, built, shared, monkeypatch):
    needed = NEEDS.get(name.partition(".")[0])
    if needed and not shutil.which(needed):
        pytest.skip(f"{needed} is not installed")
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    now = transcripts.played(name, shared / "world" / name.replace("/", "-"))
    assert now == transcripts.path_of(name).read_text(encoding="utf-8"), (
        f"read the difference, then: python -m tests.transcripts --only {name} --write"
    )


def test_a_wrong_use_is_told_in_one_line():
    refused = [call for call in CALLS if call.status == 2]
    assert len(refused) > 250
    for call in refused:
        told = [line for line in call.err if not line.startswith(SAID_BEFORE)]
        assert len(told) == 1, call
        assert told[0].startswith("judge: "), call
        assert call.out == [] or call.words.startswith("export "), call  # which says what it leaves out


def test_a_fault_is_told_in_lines_of_the_judge():
    faults = [call for call in CALLS if call.status == 3]
    assert len(faults) > 40
    for call in faults:
        assert all(line.startswith("judge: ") for line in call.err), call
        assert (
            call.err or "fault  " in "\n".join(call.out) or "--json" in call.words or " JE" in str(call.out)
        )


def test_nobody_sees_the_inside_of_the_judge():
    inside = re.compile(r"internal (fault|error)|Traceback \(most recent")
    for call in CALLS:
        assert not inside.search(str((call.out, call.err))), call


def test_every_command_refuses_an_option_it_does_not_have_and_has_a_page_of_help(judge):
    for name in COMMANDS:
        assert judge(name, "--nothing").status == 2
        assert judge(name, "--help").status == 0
        assert judge(name, "--help").out.count("\n") <= 40


def terminals() -> list[tuple[Call, int, int]]:
    """Commands on a terminal, with its columns and rows; but for those that write for machines."""
    sizes = {
        name: transcripts.Transcript.read(transcripts.path_of(name).read_text()).terminal for name in NAMES
    }
    plain = [call for call in CALLS if not re.search("--json|--csv|--format", call.words)]
    return [(call, *sizes[call.name]) for call in plain if sizes[call.name]]


def is_program(call: Call, row: str) -> bool:
    """Whether it is a row of a source, which stays as it was written."""
    return call.words.split()[0] in ("hack", "quiz", "solution") and row.startswith("    ")


def test_no_row_is_wider_than_its_terminal():
    for call, columns, _ in terminals():
        wide = [row for row in call.out if len(row) > columns]
        assert [row for row in wide if not COPIED.search(row) and not is_program(call, row)] == [], call


def test_a_failure_fits_the_screen_with_its_verdict_first_and_last():
    """Where nobody asks for more, and nothing but the row of a command is broken by the terminal."""
    shown = [
        (call, columns)
        for call, columns, rows in terminals()
        if rows == 24
        and columns >= 60
        and re.match(r"run \S+ \S+$|hack .*\d", call.words)
        and call.status == 1
    ]
    assert len(shown) > 30
    for call, columns in shown:
        assert sum(-(-max(len(row), 1) // columns) for row in call.out) <= ROWS, call
        if call.words.startswith("run"):
            verdict = call.out[0].split()[0]
            assert re.search(rf"^{verdict}  ", "\n".join(call.out[-2:]), re.MULTILINE), call


def test_a_problem_without_circles_is_told_without_their_words():
    """Whole transcripts of other topics' katas, and all that is told of the tests' own kata."""
    told = [
        transcripts.path_of(name).read_text(encoding="utf-8") for name in NAMES if name.startswith("topics/")
    ]
    assert len(told) >= 4
    for call in CALLS:
        elsewhere = call.name.startswith(("refused", "faults")) or call.words.startswith(("quiz", "export"))
        if re.search(r"\bmiddle\b", call.words) and not elsewhere:
            told.append("\n".join((*call.out, *call.err)))
    assert len(told) > 100
    for text in told:
        for word in OWN:
            text = text.replace(word, "")
        assert TOPIC.findall(text) == [], text


def test_the_first_steps_are_told_in_plain_words():
    plain = re.compile(r"(?<![a-z])(bands?|epsilons?|tolerances?|extent|threshold)(?![a-z])", re.IGNORECASE)
    told = [call for call in CALLS if call.name.startswith("first-steps/")]
    assert len(told) > 12
    for call in told:
        text = "\n".join(call.out)
        assert plain.findall(text) == [], call
