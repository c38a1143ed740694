"""Exit codes that scripts may rely on: every command, every situation.

0 accepted, sound, shown    1 not accepted    2 usage    3 the judge's or a problem's own fault
130 interrupted             141 the reader of the output has left
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from cli_support import BROKEN, FLOOR, MEAN, ROOT

from judge.cli.table import COMMANDS

pytestmark = pytest.mark.slow

FILES = {
    "mean.py": MEAN,
    "floor.py": FLOOR,
    "raises.py": "def middle(a, b):\n    return a / 0\n",
    "broken.py": "def middle(a, b)\n",
    "hog.py": "def middle(a, b):\n    return [0] * 10**9\n",
    "team/mean.py": MEAN,
    "team/floor.py": FLOOR,
    "good/mean.py": MEAN,
    "homework/ada/middle.py": MEAN,
    "note.txt": "no report\n",
    "old.svg": "no picture",
    "other.sqlite3": "no history",
}
TABLE = {  # by status; what stands before a `;` is only done before
    0: [
        "",
        "--help",
        "--version",
        "run middle mean.py",
        "run middle mean.py -q",
        "run middle mean.py --json",
        "run middle mean.py --format github --junit out.xml",
        "run middle good",
        "run middle floor.py --group whole",
        "list",
        "show middle",
        "why middle half",
        "data middle --out data",
        "export middle --out packages --no-submissions --zip --json",
        "new pack mine",
        "verify middle",
        "doctor",
        "help",
        "init middle",
        "hint count",
        "next",
        "solution count --give-up",
        "history",
        "history --csv",
        "run middle floor.py -q; run middle mean.py -q; diff 1 2",
        "bench middle --rounds 1",
        "practice junior",
        "quiz halves",
        "quiz halves --check",
        "quiz halves --list --json",
        "progress",
        "due",
        "run middle floor.py -q; report --no-matrix",
        "stress middle mean.py --for 0.1s",
        "worker --new-keys keys",
        "schema",
        "schema run",
        "completion bash",
        "try middle 1 2",
        "try middle 1,2 mean.py",
        "hack middle",
        "explore",
        "explore count 0,0,1,(-1,1),(1,1) --out page.html",
        "explore count; explore segment",
        "hack middle --list",
        "hack middle 1 1,2",
        "class homework",
        "class homework --shard 1/1 -q; class homework --merge homework.judge.1-of-1.sqlite3",
    ],
    1: [
        "run middle floor.py --no-shrink",
        "run middle floor.py --no-shrink --json",
        "run middle floor.py --no-shrink --format github",
        "run middle floor.py --no-shrink --junit out.xml -q",
        "run middle raises.py --no-shrink",
        "run middle broken.py",
        "run middle hog.py --no-shrink --group examples",
        "run middle team --no-shrink",
        "run middle mean.py floor.py -j 2 -q",
        "stress middle floor.py --for 1s --no-shrink --no-name",
        "stress middle floor.py --for 1s --no-shrink --no-name --json",
        "stress middle broken.py",
        "init middle; run",
        "run middle floor.py -q --no-history",
        "try middle 1 2 floor.py",
        "hack middle 1,1",
        "hack middle 1 2000",
        "hack middle --give-up",
    ],
    2: [
        "nothing",
        "--nothing",
        "run",
        "run middle mean.py --no-such",
        "init middle mean.py",
        "init middel",
        "hint",
        "hint middle --step 99",
        "solution count",
        "watch",
        "watch middle gone.py --nothing",
        "history --csv --json",
        "history middel",
        "diff 1 2",
        "diff one two",
        "practice nothing",
        "quiz nothing",
        "quiz --row J99",
        "quiz --interview --minutes 0",
        "progress nothing",
        "due x",
        "next x",
        "report",
        "run middle floor.py -q; report --out note.txt --no-matrix",
        "run middel mean.py",
        "run middle",
        "run middle gone.py",
        "run middle mean.py --nothing",
        "run middle mean.py --group nothing",
        "run middle mean.py --seed x",
        "run middle mean.py --format xml",
        "run middle mean.py --format text --json",
        "run middle mean.py --junit nowhere/out.xml",
        "run middle mean.py --junit mean.py",
        "run middle mean.py --svg old.svg",
        "run middle mean.py --problems nowhere",
        "stress middle",
        "stress middel mean.py",
        "stress middle gone.py",
        "stress middle mean.py --for x",
        "stress middle mean.py --group nothing",
        "stress middle mean.py --svg old.svg",
        "try middle 1",
        "try middle 1 2 gone.py",
        "try middle 1 2000",
        "hack middle 1 2 3 4",
        "hack middle nothing",
        "explore middle",
        "explore count --out note.txt",
        "explore count 1 2",
        "explore count:grid:v1:000000",
        "hack middle 2",
        "hack middle --lst",
        "history --restore 1",
        "run middle mean.py --level interview",
        "replay nothing mean.py",
        "replay middle:half:v1,2:000000 mean.py",
        "list --problems nowhere",
        "show middel",
        "why middle nothing",
        "data middle",
        "data middle --out note.txt",
        "export",
        "export middle",
        "export --out packages",
        "export middle --all --out packages",
        "export middle --out note.txt --no-submissions",
        "export middle --out packages --version 2023",
        "export nearest --out packages",
        "verify middel",
        "new pack Mine",
        "doctor x",
        "worker tcp://10.0.0.1:8786",
        "worker tls://localhost:1 --scheduler --keys team",
        "worker --new-keys keys; worker --new-keys keys",
        "class homework --on ssh:gone.txt",
        "class homework --on udp://localhost:1",
        "class homework --on tcp://127.0.0.1:1 -j 2",
        "schema nothing",
        "completion ksh",
    ],
    3: [
        "worker tcp://127.0.0.1:1",
        "class homework --on tcp://127.0.0.1:1",
        f"run misspelt-key mean.py --problems {BROKEN}",
        f"run misspelt-key mean.py --json --problems {BROKEN}",
        f"run misspelt-key mean.py --junit out.xml --problems {BROKEN}",
        f"list --problems {BROKEN}",
        f"show misspelt-key --problems {BROKEN}",
        f"why misspelt-key --problems {BROKEN}",
        f"export module-raises --out data --problems {BROKEN}",
        f"data module-raises --out data --problems {BROKEN}",
        f"verify misspelt-key --problems {BROKEN}",
        f"stress misspelt-key mean.py --problems {BROKEN}",
        f"stress module-raises mean.py --json --problems {BROKEN}",
        f"init misspelt-key --problems {BROKEN}",
        f"try misspelt-key 1 --problems {BROKEN}",
        f"try module-raises 1 --problems {BROKEN}",
        "history --db other.sqlite3",
        "due --db other.sqlite3",
        "report --db other.sqlite3",
    ],
}


@pytest.fixture
def files(submit):
    for name, source in FILES.items():
        submit(source, name)


@pytest.mark.parametrize(
    ("status", "words"), [(status, words) for status, all_words in TABLE.items() for words in all_words]
)
def test_a_situation_has_its_code(status, words, judge, files):
    *before, last = words.split(";")
    for each in before:
        judge(*each.split())
    ended = judge(*last.split())
    assert ended.status == status, ended
    assert "Traceback" not in ended.err
    if status in (2, 3) and "verify" not in words:
        assert ended.err.startswith("judge: "), ended


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_refuses_an_option_it_does_not_have(name, judge):
    assert judge(name, "--nothing").status == 2
    assert judge(name, "--help").status == 0


def test_every_command_is_in_the_table():
    words = {line.split(";")[-1].split()[0] for lines in TABLE.values() for line in lines if line}
    assert set(COMMANDS) <= words


@pytest.mark.parametrize("name", COMMANDS)
def test_an_interrupt_is_130(name):
    script = f"""
import os, signal, sys
class Interrupting:
    def find_spec(self, name, *rest):
        if name == "judge.cli.commands.{name}":
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Interrupting())
sys.argv = ["judge", {name!r}]
from judge.cli import main
main()
"""
    command = [sys.executable, "-c", script]
    ended = subprocess.run(command, capture_output=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, b"", b"")


READERS = ["list", "show segment", "why segment", "schema run", "completion zsh", "doctor", "list --json"]


@pytest.mark.parametrize("words", [*READERS, *(f"{name} --help" for name in COMMANDS)])
def test_a_reader_that_has_left_is_141(words):
    reading, writing = os.pipe()
    os.close(reading)
    command = [sys.executable, "-m", "judge", *words.split()]
    ended = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, timeout=60, check=False)
    os.close(writing)
    assert (ended.returncode, ended.stderr) == (141, b"")


def test_results_that_nobody_reads_are_141(files):
    for words in ("run middle floor.py -q --no-shrink", "run middle floor.py --format github --no-shrink"):
        reading, writing = os.pipe()
        os.close(reading)
        command = [sys.executable, "-m", "judge", *words.split()]
        settings = {**os.environ, "PYTHONPATH": str(ROOT)}
        ended = subprocess.run(
            command, stdout=writing, stderr=subprocess.PIPE, timeout=60, check=False, env=settings
        )
        os.close(writing)
        assert (ended.returncode, ended.stderr) == (141, b"")
