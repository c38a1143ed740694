"""Katas whose programs are talked with: who is to blame, and what both sides have said."""

import shutil
from pathlib import Path

import pytest

import judge
from judge.data.load import load_data
from judge.errors import JudgeError, ProblemError
from judge.judging import RunOptions
from judge.judging.cases import ask, try_case
from judge.judging.inprocess import InProcess
from judge.judging.session import Session
from judge.languages.boxes import AnyBoxes
from judge.practice.stub import make_stub
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.report.tell import tell
from judge.run.execute import judge_submission
from judge.run.formatted import FormatRunner
from judge.run.settings import Settings
from judge.sandbox import Containment, Limits, Stop
from judge.site.build import _listed
from judge.testing import judge_problem
from judge.verify.gate import Options, verify_problem
from tests.unit.native import need

pytestmark = pytest.mark.slow

KATAS = Path(judge.__file__).parent / "manual" / "katas"
SOLUTIONS = KATAS / "solutions/higher-lower"
RIGHT = (SOLUTIONS / "accepted/halving.py").read_text()
GROUPS = """GROUPS = [
    group("few", "A few numbers.", numbers(2, 12), cases=20),
    group("many", "Many numbers.", numbers(1000, 1_000_000)),
    group("last", "It is the last of the numbers.", last),
]"""
SHORT = "cpu_seconds = 0.5\nwall_seconds = 3"
UNFLUSHED = "import sys\nsys.stdin.readline()\nprint(1)\nsys.stdin.readline()"
PYPY = "import sys\ninput = lambda: sys.stdin.readline().strip()\n" + RIGHT
JAVASCRIPT = """
const lines = require("readline").createInterface({ input: process.stdin });
let low = 1, high = 0, guess = 0;
lines.on("line", (line) => {
    if (line === "found") return lines.close();
    if (!high) high = Number(line);
    else if (line === "higher") low = guess + 1;
    else high = guess - 1;
    guess = Math.floor((low + high) / 2);
    console.log(String(guess));
});
"""
GO = """package main

import "fmt"

func main() {
    low, high, answer := 1, 0, ""
    fmt.Scan(&high)
    for answer != "found" {
        guess := (low + high) / 2
        fmt.Println(guess)
        fmt.Scan(&answer)
        if answer == "higher" { low = guess + 1 }
        if answer == "lower" { high = guess - 1 }
    }
}
"""
RUST = """
use std::io;

fn line() -> String {
    let mut text = String::new();
    io::stdin().read_line(&mut text).unwrap();
    text.trim().to_string()
}

fn main() {
    let (mut low, mut high): (i64, i64) = (1, line().parse().unwrap());
    loop {
        let guess = (low + high) / 2;
        println!("{}", guess);
        match line().as_str() {
            "higher" => low = guess + 1,
            "lower" => high = guess - 1,
            _ => break,
        }
    }
}
"""
C = """
#include <stdio.h>
#include <string.h>

int main(void) {
    int low = 1, high;
    char answer[10] = "";
    scanf("%d", &high);
    while (strcmp(answer, "found")) {
        int guess = (low + high) / 2;
        printf("%d\\n", guess);
        fflush(stdout);
        if (scanf("%9s", answer) != 1) return 1;
        if (!strcmp(answer, "higher")) low = guess + 1;
        if (!strcmp(answer, "lower")) high = guess - 1;
    }
    return 0;
}
"""


@pytest.fixture
def kata(tmp_path):
    """The folder of a copy of the kata, with its examples and one group, to be changed."""
    for kind in ("problems", "solutions"):
        shutil.copytree(KATAS / kind / "higher-lower", tmp_path / kind / "higher-lower")
    folder = tmp_path / "problems" / "higher-lower"
    change(folder / "problem.py", GROUPS, 'GROUPS = [group("few", "Few numbers.", numbers(2, 9), cases=3)]')
    change(folder / "problem.toml", "cpu_seconds = 4\nwall_seconds = 12", SHORT)
    return folder


def change(file, old, new):
    text = file.read_text()
    assert text.count(old) == 1
    file.write_text(text.replace(old, new))


def judged(folder, source, name="mine.py", level=None):
    data = load_data(load_problem(folder), store=None)
    boxes = Containment(level) if level else Containment()
    settings = Settings(measured=False, box_factory=AnyBoxes(boxes, None))
    return judge_submission(data, source.encode(), name, settings).result


def test_a_right_program_is_accepted(kata):
    result = judged(kata, RIGHT)
    assert result.verdict is Verdict.AC
    assert [group.passed for group in result.groups] == [2, 3]


@pytest.mark.parametrize(
    ("source", "verdict", "told", "said"),
    [
        ("for n in range(1, int(input())): print(n, flush=True); input()",
         Verdict.WA, "not found in 3 guesses", "> 6\n< 1\n> higher\n< 2\n> higher\n< 3\n> higher"),
        (UNFLUSHED, Verdict.TLE, "flush", "> 6"),
        ("print(1, end='', flush=True)\ninput()\ninput()", Verdict.TLE, "line feed", "without a line feed"),
        ("input()\nwhile True: pass", Verdict.TLE, "CPU time", "> 6"),
        ("print(3, flush=True)\ninput()\ninput()\n1 / 0", Verdict.RTE, "ZeroDivisionError", "> higher"),
        ("import os\nprint(3, flush=True)\nos._exit(3)", Verdict.RTE, "exit status 3", "< 3"),
        ("while True: print('1' * 999, end='')", Verdict.OLE, "wrote more than", "> 6"),
        ("print(3)", Verdict.WA, "the program ended, where a number from 1 to 6", "< 3\n> higher"),
        ("", Verdict.WA, "the program ended", "> 6"),
        ("print('three')", Verdict.WA, "a number from 1 to 6 is expected, not 'three'", "< three"),
        ("print(7)", Verdict.WA, "not '7'", "< 7"),
        ("print('9' * 5000)", Verdict.WA, "a number from 1 to 6 is expected", "< 999"),
        (RIGHT + "print('and out')", Verdict.WA, "'and out' after the dialogue", "> found\n< and out"),
        (RIGHT + "raise SystemExit(4)", Verdict.RTE, "exit status 4", "> found"),
        (RIGHT + "while True: print('x' * 999)", Verdict.OLE, "wrote more than", "> found"),
        (RIGHT + "import time\ntime.sleep(99)", Verdict.TLE, "took more than 3 s", "> found"),
        ("a = bytearray(1 << 40)", Verdict.MLE, "MemoryError", ""),
    ],
)  # fmt: skip
def test_each_way_to_fail_is_told(kata, source, verdict, told, said):
    result = judged(kata, source)
    assert result.verdict is verdict, result
    assert told in result.failure.message
    assert said in result.failure.shown
    assert ("flush" in told) is ("flush" in result.failure.message and "print(1, end" not in source)


def test_a_wrong_program_is_not_waited_for(kata):
    """What talk says ends it: it would use up all its time, and the next cases would not be run."""
    result = judged(kata, "print(0, flush=True)\nwhile True: pass")
    assert (result.verdict, result.failure.message) == (
        Verdict.WA,
        "a number from 1 to 6 is expected, not '0'",
    )
    assert [group.run for group in result.groups] == [True, True]


def test_a_dialogue_that_nobody_ends(kata):
    change(kata / "problem.py", "for _ in range(high.bit_length())", "while True")
    slow = "import time\ninput()\nwhile True:\n    print(1, flush=True)\n    input()\n    time.sleep(0.05)"
    found = judged(kata, slow)
    assert found.verdict is Verdict.TLE
    assert "the dialogue was not over after 3" in found.failure.message


@pytest.mark.parametrize("endless", ["pass", "program.hear()", 'program.say("x" * 99999)'])
def test_a_talk_that_does_not_mind_the_end(kata, endless):
    change(kata / "problem.py", "program.say(high)", f"program.say(high)\n    while True: {endless}")
    if endless == "pass":  # the program is not to blame
        with pytest.raises(ProblemError, match="talk works on"):
            judged(kata, "print(1)")
    else:
        result = judged(kata, "print(1)")
        assert result.verdict is Verdict.WA
        assert "the program ended" in result.failure.message


def test_a_talk_that_takes_too_long_is_not_the_programs_fault(kata):
    change(kata / "problem.py", "program.say(high)", "import time; time.sleep(3.5); program.say(high)")
    with pytest.raises(ProblemError, match="talk works on"):
        judged(kata, RIGHT)


def test_what_talk_takes_is_not_counted_for_the_program(kata):
    """The third one of a group would have no time left."""
    change(kata / "problem.py", "program.say(high)", "import time; time.sleep(1.2); program.say(high)")
    assert judged(kata, RIGHT).verdict is Verdict.AC


def test_a_group_that_has_no_time_left_blames_no_talk(kata):
    """The talk needs a moment to see that its program is gone."""
    runner, limits = FormatRunner(load_problem(kata)), Limits(1.0, 1e-4, 256 << 20, 1 << 20)
    slow = f"import time\ntime.sleep(0.5)\n{RIGHT}"
    with Containment()(slow.encode(), "mine.py") as box:
        for _ in range(10):
            assert runner.ask(box, [(6, 5)], limits).stop is Stop.WALL


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ("1 / 0", "talk fails: ZeroDivisionError"),
        ("return 3", "talk returns 3"),
        ("return ''", "talk returns ''"),
        ("program.say('\\u00e9')", "UnicodeEncodeError"),
        ("exit()", "SystemExit"),
    ],
)
def test_what_talk_does_wrong_is_the_kata_s_fault(kata, wrong, told):
    change(kata / "problem.py", "program.say(high)", wrong)
    with Session(load_problem(kata), RunOptions(timed=False)) as session:
        result = session.judge(RIGHT.encode(), "mine.py")
    assert result.verdict is Verdict.JE
    assert told in result.failure.message


def test_the_smallest_dialogue_is_shown(kata):
    with Session(load_problem(kata), RunOptions(timed=False)) as session:
        source = (SOLUTIONS / "wrong/guess-kept.py").read_bytes()
        result = session.judge(source, "mine.py")
        told = tell(session.problem, result)
    small = result.counterexample
    assert told.input == ("high = 2", "secret = 2")
    assert told.facts == (("dialogue", small.shown), ("why", "the number is not found in 2 guesses"))
    assert small.input == {"high": 2, "secret": 2}
    assert small.shown == "> 2\n< 1\n> higher\n< 1\n> higher"


def test_only_the_last_lines_are_shown(kata):
    change(kata / "problem.py", "high.bit_length())", "99)")
    shown = judged(kata, "input()\nwhile True:\n    print(1, flush=True)\n    input()").failure.shown
    assert shown.count("\n") == 20
    assert shown.startswith("…\n< 1\n> higher")


@pytest.mark.parametrize("level", ["full", "strong", "limits"])
def test_at_every_level(kata, level):
    try:
        assert judged(kata, RIGHT, level=level).verdict is Verdict.AC
    except JudgeError as fault:
        pytest.skip(str(fault))
    assert judged(kata, "print(9)", level=level).verdict is Verdict.WA


@pytest.mark.parametrize(
    ("language", "name", "source"),
    [
        ("cpp", "mine.cpp", (SOLUTIONS / "accepted/halving.cpp").read_text()),
        ("java", "Halving.java", (SOLUTIONS / "accepted/Halving.java").read_text()),
        ("c", "mine.c", C),
        ("go", "mine.go", GO),
        ("rust", "mine.rs", RUST),
        ("javascript", "mine.js", JAVASCRIPT),
        ("pypy", "mine.pypy.py", PYPY),
    ],
)
def test_a_program_in_another_language(kata, language, name, source):
    need(language)
    change(kata / "problem.toml", SHORT, "cpu_seconds = 4\nwall_seconds = 20")
    result = judged(kata, source, name)
    assert result.verdict is Verdict.AC, result
    wrong = judged(kata, source.replace("higher", "upper"), name)
    assert wrong.verdict in (Verdict.WA, Verdict.RTE)


def test_a_session_takes_another_language(kata):
    """A kata without entry has no function that a driver could call."""
    need("cpp")
    with Session(load_problem(kata), RunOptions(timed=False)) as session:
        source = (SOLUTIONS / "accepted/halving.cpp").read_bytes()
        assert session.judge(source, "mine.cpp").verdict is Verdict.AC


def test_not_in_this_process(kata):
    settings = Settings(measured=False, box_factory=InProcess)
    with pytest.raises(JudgeError, match="on the command line"):
        judge_submission(load_data(load_problem(kata), store=None), RIGHT.encode(), "mine.py", settings)
    with pytest.raises(JudgeError, match="on the command line"):
        judge_problem("higher-lower", problems=[kata.parent])
    assert "on the command line only" in _listed(load_problem(kata))["elsewhere"]


def test_the_file_to_begin_with(kata):
    problem = load_problem(kata)
    assert judged(kata, make_stub(problem)).failure.message.startswith("NotImplementedError")


@pytest.mark.parametrize(
    ("file", "old", "new", "told"),
    [
        ("problem.py", "Format(talk=talk)", "Format(str, talk=talk)", "Format has talk and write"),
        ("problem.py", "Format(talk=talk)", "Format()", "Format has no write"),
        ("problem.toml", 'tier = "junior"', 'tier = "junior"\nanswer = "int"', "a dialogue has no answer"),
        ("problem.toml", "summary", 'entry = "guess"\nanswer = "int"\nsummary', "calls no function"),
        ("statement.md", "# Higher", "# {{examples}} Higher", "unknown placeholder"),
        ("statement.md", "# Higher", ">>> guess(1)\n# Higher", "has no calls"),
    ],
)
def test_wrong_use_is_told(kata, file, old, new, told):
    change(kata / file, old, new)
    with pytest.raises(ProblemError) as fault:
        load_problem(kata)
    assert told in fault.value.what
    assert fault.value.remedy
    assert f"higher-lower/{file}" in fault.value.where


def test_other_programs_have_an_answer(kata):
    change(kata / "problem.py", "Format(talk=talk)", "Format(str)")
    with pytest.raises(ProblemError, match="the key 'answer' is missing"):
        load_problem(kata)


def test_a_talk_is_tried_on_odd_programs(kata):
    change(kata / "problem.py", "program.hear_int(1, high)", "int(program.hear())")
    found = verify_problem(load_problem(kata), Options())
    assert any("talk fails: ValueError" in each.what for each in found.warnings)


@pytest.mark.parametrize(
    ("source", "verdict", "end"), [(RIGHT, Verdict.AC, "> found"), ("print(7)", Verdict.WA, "< 7")]
)
def test_a_case_of_ones_own_shows_what_was_said(kata, source, verdict, end):
    problem = load_problem(kata)
    with Session(problem, RunOptions(timed=False)) as session:
        said = ask(session, try_case(problem, (6, 4)), source.encode(), "mine.py")
    assert said.verdict is verdict
    assert said.printed.startswith("> 6\n<")
    assert said.printed.endswith(end)


def test_a_dialogue_is_raced_with_the_reference(kata):
    with (kata / "problem.toml").open("a") as file:
        file.write('\n[time]\nlimit = 50\nprogram = "halving.py"\n')
    with Session(load_problem(kata), RunOptions(diagnosed=False, named=False)) as session:
        result = session.judge(RIGHT.encode(), "mine.py")
    assert result.verdict is Verdict.AC
    assert 0.1 < result.time.ratio.median < 10
