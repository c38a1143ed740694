"""The pytest plug-in and `judge.testing`, as an author of a library uses them."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from importlib.metadata import entry_points

import pytest
from cli_support import FLOOR, MEAN, ROOT

from judge.manual import page
from judge.testing import judge_problem

pytest_plugins = ["pytester"]

# As `import` finds it where judge is not installed, only on the path; installed, pytest has loaded it itself.
_INSTALLED = any(point.value == "judge.pytest_plugin" for point in entry_points(group="pytest11"))
LOADED = () if _INSTALLED else ("-p", "judge.pytest_plugin")
# Others' plug-ins are imported anew by each of these runs, and Hypothesis takes seconds.
ALONE = ("-p", "no:cacheprovider", "-p", "no:hypothesispytest", "-p", "no:anyio")

pytestmark = pytest.mark.slow

MARKED = "import pytest\nfrom lib import middle\n"
GROUPS = "@pytest.mark.judge_problem('middle')\ndef test_it(judge_group):\n    judge_group.check(middle)\n"


@pytest.fixture
def library(pytester):
    """Run pytest on a library with that routine and those tests."""

    def run(source: str, tests: str, *words: str) -> pytest.RunResult:
        pytester.makeini("[pytest]\naddopts = --strict-markers\nfilterwarnings = error\n")
        pytester.makepyfile(lib=source)
        pytester.makepyfile(test_lib=tests)
        return pytester.runpytest_inprocess(*LOADED, *ALONE, *words)

    return run


def test_a_failure_is_that_of_its_group(library):
    ended = library(FLOOR, MARKED + GROUPS)
    ended.assert_outcomes(passed=1, failed=2)
    ended.stdout.fnmatch_lines(
        [
            "*test_it[[]half[]]*",
            "E * middle: middle fails 30 of 30 cases",
            "E *Smallest failing case*",
            "E * a = 0, b = 1",
            "E * expected *.5",
            "E * got *",
            "E * why * the answer is off by 0.5,*",
            "E *It answers like floor-division",
            "test_lib.py:5: AssertionError",
        ]
    )
    assert "judge/testing.py" not in ended.stdout.str()  # the traceback ends at the test's own line


@pytest.mark.parametrize(
    ("marker", "said"),
    [
        (
            "@pytest.mark.judge_problem('middel')",
            "judge_problem: no kata is called 'middel'; did you mean*",
        ),
        (
            "@pytest.mark.judge_problem('middle', ['hlaf'])",
            "*middle has no group 'hlaf'; did you mean 'half'?",
        ),
        ("@pytest.mark.judge_problem('middle', 'half')", "the marker judge_problem cannot be understood: *"),
        ("", "the fixture judge_group needs a problem: write @pytest.mark.judge_problem*"),
    ],
)
def test_a_bad_marker_is_one_line_and_fails_its_own_test_alone(marker, said, library):
    other = "def test_other():\n    assert middle(0, 2) == 1\n"
    ended = library(MEAN, f"{MARKED}{marker}\ndef test_it(judge_group):\n    pass\n\n\n{other}")
    ended.assert_outcomes(errors=1, passed=1)
    ended.stdout.fnmatch_lines([said])
    assert "Traceback" not in ended.stdout.str()
    assert "INTERNALERROR" not in ended.stdout.str()


def test_a_process_that_had_to_be_ended_says_so_in_spite_of_what_pytest_captures(pytester):
    pytester.makepyfile(
        "from judge.judging import clock\n"
        "from judge.testing import judge_problem\n"
        "def test_it(monkeypatch):\n"
        "    monkeypatch.setattr(clock, 'GRACE', 0.5)\n"
        "    judge_problem('middle').check(lambda *_: sum(range(10**18)), seconds=0.5)\n"
    )
    ended = pytester.runpytest_subprocess(*LOADED, *ALONE)
    assert ended.ret == -signal.SIGKILL
    ended.stderr.fnmatch_lines(["judge: * has not come back 0.5 s after *. This process ends."])


def test_nothing_of_judge_is_imported_at_the_start_of_pytest():
    script = (
        "import sys, pytest\nimport judge.pytest_plugin\nours = ('judge', 'msgspec', 'click')\n"
        "print(*sorted(name for name in sys.modules if name.partition('.')[0] in ours))"
    )
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    assert ended.stdout.split() == ["judge", "judge.pytest_plugin"]


@pytest.mark.nightly
def test_the_manuals_example(pytester, library, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    example, *_ = re.findall(r"^```py\n(.*?)^```$", page("testing").text, re.MULTILINE | re.DOTALL)
    right = (ROOT / "solutions" / "segment" / "accepted" / "quadratic.py").read_text(encoding="utf-8")
    pytester.makepyfile(right=right)
    wrapped = (
        "from right import circle_segment\n"
        "def intersect(circle, segment):\n    (c, r), (a, b) = circle, segment\n"
        "    return circle_segment(*c, r, a, b)\n"
    )
    pytester.makepyfile(mylib=wrapped)
    groups = len(judge_problem("segment").groups)
    library("", example).assert_outcomes(passed=1 + groups)
    pytester.makepyfile(mylib=wrapped.replace("return", "return []\n    return"))
    assert library("", example).ret == pytest.ExitCode.TESTS_FAILED


# -- judge.testing ---------------------------------------------------------------------------------------


def middle(a, b):
    return (a + b) / 2


def floor(a, b):
    return (a + b) // 2


def test_a_wrong_one_counts_the_failures_of_each_group():
    with pytest.raises(AssertionError) as failed:
        judge_problem("middle").check(floor)
    first, *rest = str(failed.value).splitlines()
    assert first == "middle: floor fails 2 of 3 groups, 31 of 52 cases"
    assert rest[0] == "  fails  examples 1/2, half 0/30"
    assert [line.split()[0] for line in rest if line.startswith("  ")][2:5] == ["expected", "got", "why"]


def test_an_exception_is_a_failure_that_leads_to_its_line():
    def stumbles(a, b):
        return a / (b - b)

    with pytest.raises(AssertionError, match=r"fails 3 of 3 groups,\s52 of 52 cases") as failed:
        judge_problem("middle").check(stumbles)
    assert f"ZeroDivisionError: division by zero ({__file__}:" in " ".join(str(failed.value).split())
    assert isinstance(failed.value.__cause__, ZeroDivisionError)


def test_a_routine_is_asked_in_other_ways_too():
    def expands(cx, cy, r, point):
        x, y = point
        size = max(r, abs(x - cx), abs(y - cy))
        square = x * x + y * y - 2 * (x * cx + y * cy) + cx * cx + cy * cy
        gap = abs(square) ** 0.5 - r
        return 0 if abs(gap) <= 1e-9 * size else 1 if gap > 0 else -1

    with pytest.raises(AssertionError, match="The program is right if the first point of every case is the"):
        judge_problem("on-circle").check(expands)
