"""Katas of programs, which say themselves what a program reads and writes."""

import re
import shutil
from pathlib import Path

import pytest

import judge
from judge.data.load import load_data
from judge.errors import ProblemError
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.languages.boxes import AnyBoxes
from judge.practice.stub import make_stub
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run.execute import judge_submission
from judge.run.settings import Settings
from judge.sandbox import Containment
from judge.verify.gate import Options, verify_problem
from tests.unit.native import need

pytestmark = pytest.mark.slow

KATAS = Path(judge.__file__).parent / "manual" / "katas"
RIGHT = (KATAS / "solutions/depot/accepted/exact.py").read_text()
LAST = '(1, (("ask", 1, 0),))]'  # of its examples
CPP = """
#include <iostream>
#include <string>
#include <vector>

int main() {
    int shelves, count, shelf;
    std::string word, skip;
    std::cin >> shelves >> skip;
    std::vector<int> boxes(shelves + 1);
    while (std::cin >> word && word != "end") {
        if (word == "how") {
            std::cin >> skip >> skip >> skip >> shelf;
            std::cout << boxes[shelf] << '\\n';
            continue;
        }
        std::cin >> count >> skip >> skip >> shelf;
        if (word == "put") boxes[shelf] += count;
        else if (boxes[shelf] < count) std::cout << "refused\\n";
        else std::cout << (boxes[shelf] -= count) << '\\n';
    }
}
"""


@pytest.fixture
def depot(tmp_path):
    """The folder of a copy of the kata, to be changed."""
    for kind in ("problems", "solutions"):
        shutil.copytree(KATAS / kind / "depot", tmp_path / kind / "depot")
    return tmp_path / "problems" / "depot"


def change(file, old, new):
    text = file.read_text()
    assert text.count(old) == 1
    file.write_text(text.replace(old, new))


def judged(folder, source, name="mine.py"):
    data = load_data(load_problem(folder), store=None)
    settings = Settings(measured=False, box_factory=AnyBoxes(Containment(), None))
    return judge_submission(data, source.encode(), name, settings).result


def test_each_case_is_a_run_of_its_own(depot):
    result = judged(depot, RIGHT)
    assert result.verdict is Verdict.AC
    assert [group.passed for group in result.groups] == [2, 12, 20, 20]
    assert judged(depot, f"{RIGHT}\nprint('refused')").verdict is Verdict.WA


@pytest.mark.parametrize(
    ("source", "verdict", "told"),
    [
        ("", Verdict.WA, "5 items expected, none given"),
        ("print('two')", Verdict.WA, "a line is a number or 'refused', not 'two'"),
        ("print('\\u00b2')", Verdict.WA, "a line is a number or 'refused'"),
        ("import sys\nif 'take' in sys.stdin.read(): 1 / 0", Verdict.RTE, "ZeroDivisionError"),
        ("import sys\nsys.exit(3)", Verdict.RTE, "3"),
        ("while True: pass", Verdict.TLE, "CPU time"),
        ("while True: print('refused' * 1000)", Verdict.OLE, "wrote more than"),
        ("import os\nos.kill(os.getpid(), 9)", Verdict.RTE, ""),
    ],
)
def test_each_way_to_fail_is_told(depot, source, verdict, told):
    change(depot / "problem.toml", "cpu_seconds = 4\nwall_seconds = 12", "cpu_seconds = 1\noutput_mb = 0.1")
    change(depot / "problem.py", "(2, ((", "(2, (('ask', 1, 0), ('ask', 1, 0), (")
    result = judged(depot, source)
    assert result.verdict is verdict, result
    assert told in result.failure.message


def test_the_time_of_all_runs_is_told_as_such(depot):
    change(depot / "problem.toml", "cpu_seconds = 4\nwall_seconds = 12", "cpu_seconds = 1")
    slow = "import time\nwhile time.process_time() < 0.3: pass\n"
    failure = judged(depot, slow + RIGHT).failure
    assert re.fullmatch(r"[345] runs took more than 1 s of CPU time", failure.message)


def test_a_failing_run_costs_its_own_case_alone(depot):
    broken = "import sys\ntext = sys.stdin.read()\nassert 'take 4' not in text\n"
    result = judged(depot, broken + RIGHT.replace("sys.stdin.read()", "text"))
    assert result.verdict is Verdict.RTE
    first = result.groups[0]
    assert (first.passed, first.cases) == (1, 2)
    assert sum(group.passed for group in result.groups) > 20


def test_a_smallest_case_is_shown_as_it_is_read(depot):
    with Session(load_problem(depot), RunOptions(timed=False)) as session:
        source = (depot.parents[1] / "solutions/depot/wrong/below-zero.py").read_bytes()
        small = session.judge(source, "mine.py").counterexample
    assert small.shown == "1 shelves\ntake 1 from shelf 1\nend"
    assert (small.expected, small.got) == ("refused", "-1")


def test_what_reads_an_output_may_fail_on_it(depot):
    """Nothing that a program prints is a fault of the judge."""
    change(depot / "problem.py", "lines = output.splitlines()", "lines = [output.splitlines()[9]]")
    result = judged(depot, "print(1)")
    assert result.verdict is Verdict.WA
    assert result.failure.message == "the output cannot be read: IndexError"


def test_without_read_and_show_the_words_of_an_output_are_the_answer(depot):
    change(depot / "problem.py", "Format(write, read, show)", "Format(write)")
    source = RIGHT.replace("print(boxes[shelf])", "said.append(boxes[shelf])")
    source = source.replace('print("refused")', "said.append('none')")
    source = (
        source.replace("boxes = [0]", "said = []\nboxes = [0]")
        + "print(len(said))\nprint(*said, sep='\\n')\n"
    )
    assert judged(depot, source).verdict is Verdict.AC
    assert judged(depot, "").failure.message == "nothing was printed"
    assert "needs 3 more, 4 given" in judged(depot, source + "print(7)").failure.message


def test_a_program_is_raced_with_the_reference(depot):
    with (depot / "problem.toml").open("a") as file:
        file.write('\n[time]\nlimit = 50\nprogram = "exact.py"\n')
    with Session(load_problem(depot), RunOptions(diagnosed=False, named=False)) as session:
        result = session.judge(RIGHT.encode(), "mine.py")
    assert result.verdict is Verdict.AC
    assert 0.1 < result.time.ratio.median < 10


def test_a_program_in_another_language(depot):
    need("cpp")
    assert judged(depot, CPP, "mine.cpp").verdict is Verdict.AC
    wrong = CPP.replace("<< (boxes[shelf] -= count)", "<< boxes[shelf]")
    assert judged(depot, wrong, "mine.cpp").verdict is Verdict.WA


def test_a_function_or_a_program_where_there_is_an_entry(depot):
    change(depot / "problem.toml", 'tier = "junior"', 'tier = "junior"\nentry = "depot"')
    change(depot / "statement.md", "{{examples}}", ">>> depot(1, [('ask', 1, 0)])\n[0]")
    function = (depot / "problem.py").read_text().replace("def solve", "def depot").partition("def write")[0]
    function = function.replace(
        "from judge.problem.declare import Format, InvalidCase, group", "InvalidCase = ValueError"
    )
    assert judged(depot, function).verdict is Verdict.AC
    assert judged(depot, RIGHT).verdict is Verdict.AC


def test_the_statement_and_the_file_to_begin_with(depot):
    problem = load_problem(depot)
    assert "Input\n\n```\n2 shelves\nput 3 on shelf 1\n" in problem.statement
    assert "Output\n\n```\n3\nrefused\n2\n```" in problem.statement
    stub = make_stub(problem)
    assert "import sys" in stub
    assert judged(depot, stub).failure.message.startswith("NotImplementedError: depot is still to be written")


def test_no_entry_and_no_format(depot):
    change(depot / "problem.py", "FORMAT = Format(write, read, show)", "")
    with pytest.raises(ProblemError, match="no entry, and problem"):
        load_problem(depot)


@pytest.mark.parametrize(
    ("file", "old", "new", "told"),
    [
        ("problem.py", "Format(write, read, show)", "Format(write, read)", "Format has read without show"),
        ("problem.py", "Format(write, read, show)", "Format(write, show=show)", "show without read"),
        ("problem.py", "Format(write, read, show)", "write", "which is no Format"),
        ("problem.py", "EXAMPLES", "SAMPLES", "EXAMPLES is missing"),
        ("problem.py", '"end"]) + "\\n"', '"end"])', "FORMAT: write gives '2 shelves"),
        ("problem.py", LAST, "(1, (('put', 2, 1),))]", "case 2 is invalid: there is no shelf 2"),
        ("problem.py", LAST, "(1,)]", "EXAMPLES: case 2 is no case"),
        ("problem.py", LAST, "('a', ())]", "EXAMPLES: case 2 is invalid: shelves has"),
        ("statement.md", "{{examples}}", ">>> depot(1)\n{{examples}}", "a kata without entry has no calls"),
        ("problem.toml", "[limits]", '[time]\nlimit = 9\nfunction = "exact.py"\n[limits]', "programs alone"),
        ("problem.toml", "[limits]", "[time]\nlimit = 9\n[limits]", "programs alone"),
    ],
)  # fmt: skip
def test_wrong_use_is_told(depot, file, old, new, told):
    change(depot / file, old, new)
    with pytest.raises(ProblemError) as fault:
        load_problem(depot)
    assert told in fault.value.what
    assert fault.value.remedy
    assert f"depot/{file}" in fault.value.where


def test_a_format_is_held_against_the_cases(depot):
    change(depot / "problem.py", 'if line != "refused" and', "if")
    change(depot / "problem.py", "for line in lines:\n", "assert lines[0]\n    for line in lines:\n")
    found = verify_problem(load_problem(depot), Options())
    assert any("FORMAT: show gives" in each.what for each in found.faults)
    assert any("FORMAT: read('') raises IndexError" in each.what for each in found.warnings)
