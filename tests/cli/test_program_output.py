"""Programs by people who know other judges: prompts, labels, a wrong number of lines, files named /dev/stdin.

What cannot be read is no evidence of a mistake in geometry, and no verdict depends on the level of isolation.
"""

from __future__ import annotations

import json
import shutil

import pytest

from judge.sandbox import LEVELS
from judge.sandbox.levels import missing

pytestmark = pytest.mark.slow

PROGRAM = """\
import sys
for case in range(int(input({first}))):
    a, b = map(float, input({each}).split())
    {say}
"""
RIGHT = {"first": "", "each": "", "say": "print((a + b) / 2)"}
CPP = """\
#include <{header}>
#include <iostream>
int main() {{
    {opened}
    int n; in >> n;
    while (n--) {{ double a, b; in >> a >> b; std::cout << {label} (a + b) / 2 << "\\n"; }}
}}
"""


def judged(judge, submit, source, name="mine.py", *words):
    ended = judge("run", "middle", submit(source, name), "--mode", "program", "--json", *words)
    return json.loads(ended.out)


@pytest.mark.parametrize(
    ("changed", "why"),
    [
        ({"first": '"cases: "', "each": '"case: "'}, 'the prompt of input("cases: ") is printed too'),
        ({"say": 'print(f"Answer: {(a + b) / 2}")'}, "every answer has the wrong form"),
        ({"say": 'print("Answer:", (a + b) / 2)'}, "every answer has the wrong form"),
    ],
)
def test_a_prompt_or_a_label_is_told_as_that_and_names_no_mistake(judge, submit, changed, why):
    result = judged(judge, submit, PROGRAM.format(**RIGHT | changed))
    assert result["verdict"] == "WA"
    assert result["pitfall"] is None
    assert why in result["failure"]["message"]
    assert why in result["counterexample"]["message"]


@pytest.mark.parametrize(
    ("changed", "why"),
    [
        ({"say": "print((a + b) / 2); break"}, "1 line printed, {} expected: one for each case"),
        ({"say": "print((a + b) / 2, end=' ')"}, "1 line printed, {} expected: one for each case"),
        (
            {"say": "print((a + b) / 2, '\\n')"},
            "3 lines printed, {} expected: one for each case, and no blank lines between",
        ),
    ],
)
def test_a_wrong_number_of_lines_is_told_alone(judge, submit, changed, why):
    result = judged(judge, submit, PROGRAM.format(**RIGHT | changed))
    assert (result["verdict"], result["pitfall"], result["counterexample"]) == ("WA", None, None)
    failure, first = result["failure"], result["groups"][0]
    assert failure["message"] == why.format(first["cases"])
    assert (failure["group"], failure["case"], failure["input"]) == (first["name"], None, None)
    assert first["passed"] == 0


def test_a_case_that_gets_two_lines_alone_is_shown(judge, submit):
    source = PROGRAM.format(**RIGHT | {"say": "print((a + b) / 2, *(['more'] if a > b else []), sep='\\n')"})
    shown = judged(judge, submit, source)["counterexample"]
    assert shown["input"]["a"] > shown["input"]["b"]
    assert shown["message"] == "2 lines printed, 1 expected: one for each case"


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize(
    "source",
    [
        PROGRAM.format(**RIGHT).replace("import sys", "import sys; sys.stdin = open('/dev/stdin')"),
        PROGRAM.format(**RIGHT).replace("import sys", "import sys; sys.stdin = open('/dev/fd/0')"),
        PROGRAM.format(**RIGHT | {"say": "print((a + b) / 2, file=open('/dev/stdout', 'a'), flush=True)"}),
        PROGRAM.format(**RIGHT).replace("import sys", "assert open(__file__).read().startswith('assert')"),
        "import inspect\ndef middle(a, b):\n    assert 'inspect' in inspect.getsource(middle)\n"
        "    return (a + b) / 2\n" + PROGRAM.format(**RIGHT | {"say": "print(middle(a, b))"}),
    ],
)
def test_the_streams_and_the_own_source_are_files_at_every_level(judge, submit, source, level):
    if missing(level):
        pytest.skip(missing(level))
    result = judged(judge, submit, source, "mine.py", "--isolation", level)
    assert (result["verdict"], result["isolation"]) == ("AC", level), result["failure"]


@pytest.mark.skipif(not shutil.which("g++"), reason="g++ is not installed")
@pytest.mark.parametrize("level", LEVELS)
def test_a_compiled_program_reads_dev_stdin_at_every_level(judge, submit, level):
    if missing(level):
        pytest.skip(missing(level))
    source = CPP.format(header="fstream", opened='std::ifstream in("/dev/stdin");', label="")
    result = judged(judge, submit, source, "mine.cpp", "--isolation", level)
    assert (result["verdict"], result["isolation"]) == ("AC", level), result["failure"]
    label = CPP.format(header="cmath", opened="auto& in = std::cin;", label='"Result: " <<')
    told = judged(judge, submit, label, "label.cpp", "--isolation", level)
    assert "every answer has the wrong form" in told["failure"]["message"]
    assert told["pitfall"] is None


def test_utf_16_is_told_as_that(judge, submit):
    for encoding in ("utf-16", "utf-16-le"):
        result = judged(judge, submit, "def middle(a, b):\n    return (a + b) / 2\n".encode(encoding))
        assert result["failure"]["message"] == "the file is UTF-16; save it as UTF-8"
