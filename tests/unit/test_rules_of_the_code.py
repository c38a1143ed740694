"""What stands where in the code: no word of a topic in the engine, no way round the two runners."""

from __future__ import annotations

import re
from pathlib import Path

import judge

PACKAGE = Path(judge.__file__).parent
OF_A_TOPIC = {"topics", "problems", "solutions"}  # an installed package holds problems and solutions
WORDS = re.compile(
    r"(?<![a-z])(line[- ]and[- ]circle|circle[- ]and[- ]line|circles?|rays?"
    r"|tangents?|tangency|tangencies|segments?|extents?)(?![a-z])",
    re.IGNORECASE,
)
# Pages of the manual that show the judge at work on the problems that come with it.
SHOWN_AT_WORK = {
    "answers.md",
    "failure.md",
    "explore.md",
    "katas.md",
    "library.md",
    "scripts.md",
    "testing.md",
    "commands.md",
}
# What stays: the package's own name and description, the key `extent` of [tolerance], SVG's own element.
KEPT = re.compile(
    r"circle-line-judge|[Cc]ircle-line geometry"
    r"|\.extent\b|\"extent\"|`extent`|tolerance extent|\bextent(?=·unit|: |,| = |=| or ulps)"
)
OF_SVG = re.compile(r"</?circle\b|\.circle(-area)?\b|\"circle\"|\.tick circle\b")


def texts():
    for path in sorted(PACKAGE.rglob("*")):
        parts = path.relative_to(PACKAGE).parts
        if parts[0] == "manual" and parts[-1] in SHOWN_AT_WORK:
            continue
        if path.is_file() and path.suffix != ".pyc" and not OF_A_TOPIC & set(parts):
            yield path


def found_in(path, text):
    text = KEPT.sub("", text)
    if path.suffix in {".j2", ".css"} or path.parent.name == "drawing":
        text = OF_SVG.sub("", text)
    return [
        f"{path.relative_to(PACKAGE)}:{number}: {line.strip()}"
        for number, line in enumerate(text.split("\n"), 1)
        if WORDS.search(line)
    ]


def test_no_word_of_a_topic_is_in_the_engine():
    read = list(texts())
    assert len(read) > 100
    assert [line for path in read for line in found_in(path, path.read_text(encoding="utf-8"))] == []


def code_of(path: Path) -> str:
    """A file's text without comments."""
    return re.sub(r"#.*", "", path.read_text(encoding="utf-8"))


def places(pattern: str) -> list[str]:
    """Where the package's code matches, a file for each time."""
    return [
        path.relative_to(PACKAGE).as_posix()
        for path in sorted(PACKAGE.rglob("*.py"))
        for _ in re.finditer(pattern, code_of(path))
    ]


def test_only_the_two_runners_look_a_mode_up():
    assert places(r"\bMode\.[A-Z]+\b") == ["run/function.py", "run/program.py"]


def test_a_submission_s_answers_are_decided_in_one_place_for_each_mode():
    assert places(r"\.problem\.answer\.check(_line)?\b") == [
        "packs/export/trial.py",  # the first failing file, as the package's own judge will find it
        "run/function.py",
        "run/program.py",
    ]
    called = set(places(r"box\.(call_many|call_series|run_program)\("))
    assert called - {"sandbox/probe.py", "sandbox/native.py", "sandbox/attacking.py"} == {
        "run/function.py",
        "run/program.py",
        "packs/export/trial.py",
    }  # those two judge nothing
