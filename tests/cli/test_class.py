"""`judge class`: every file's row is that of `judge run`, kept through kills, shards and changes."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN
from msgspec.structs import replace

from judge.batch import model
from judge.batch.store import ResultStore
from judge.errors import StoreError
from judge.manual import page

pytestmark = pytest.mark.slow

WRONG = "def middle(a, b):\n    return a + b / {}\n"


@pytest.fixture
def homework(submit):
    """Ada is right, Bob wrong, Cy has Bob's text, Dan a link to nothing; the list has Zoe too, not Dan."""
    submit(MEAN, "homework/ada/middle.py")
    submit(FLOOR, "homework/bob/middle.py")
    submit(FLOOR, "homework/cy/homework.py")
    submit(b"\xef\xbb\xbfid;name;group\r\nada;Ada L;a\r\nbob;;b\r\ncy;;b\r\nzoe;Zoe;a\r\n", "list.csv")
    submit("hello\n", "homework/README.md")
    Path("homework/dan").mkdir()
    Path("homework/dan/middle.py").symlink_to("gone")
    return Path("homework")


def rows(outcome):
    found = [row for row in map(json.loads, outcome.out.splitlines()) if "student" in row]
    return {row["file"]: row for row in found}


def stored(name="homework.judge.sqlite3"):
    with ResultStore.read(Path(name)) as store:
        newest = {(row.student, row.problem, row.file): row for row in store.every()}
    return [newest[place] for place in sorted(newest)]


def lasting(result):
    """A result without its times."""
    groups = [{**group, "cpu_seconds": 0} for group in result["groups"]]
    return {**result, "groups": groups, "time": 0, "memory_bytes": 0}


def test_the_table_says_all_and_the_rows_are_those_of_judge_run(judge, homework, submit):
    submit("hello\n", "homework/a\nb.md")
    ended = judge("class", "homework", "--students", "list.csv")
    assert ended.status == 3
    assert ended.lines[:6] == [
        "      middle",
        "ada   AC 100",
        "bob   WA 40",
        "cy    WA 40=",
        "zoe   –",
        "dan?  JE",
    ]
    table = ended.lines[: ended.lines.index("middle  4 of 5 submitted, 1 accepted") - 1]
    assert [line for line in table[7:] if not line.startswith("judged with")] == [
        "= the same text as in another file, judged once",
        "? not in the list of students, or fits several of it",
        "nothing submitted: zoe",
        "dan: middle.py: it is a link to a file that is not there",
        "1 of 4 accepted, 5 students, 1 kata",
    ]
    assert ended.err == "judge: not judged: README.md, a\\nb.md: not a program, by its name\n"
    found = rows(judge("class", "homework", "--json"))
    plain = judge("run", "middle", *(f"homework/{name}" for name in found), "--no-shrink", "--json")
    for row, line in zip(found.values(), plain.lines, strict=True):
        result = json.loads(line)
        if row["verdict"] != "JE":
            assert lasting(row["result"] | {"submission": ""}) == lasting(result | {"submission": ""})
        assert (row["verdict"], row["score"]) == (result["verdict"], result["score"])
        assert row["result"]["submission"] == row["file"]
    assert [row["mistake"] for row in found.values()] == [None, "floor-division", "floor-division", None]
    assert [row["kept"] for row in found.values()] == [True, True, True, False]
    assert found["cy/homework.py"]["copied"] == "bob/middle.py"


def test_only_what_is_new_is_judged(judge, homework, submit, monkeypatch):
    assert judge("class", "homework").status == 3
    first = {row.file: row for row in stored()}
    Path("homework/dan/middle.py").unlink()
    submit(MEAN, "homework/dan/middle.py")
    submit(WRONG.format(3), "homework/bob/middle.py")
    ended = judge("class", "homework")
    assert "2 results kept from before" in ended.err
    assert "dan  AC 100=" in ended.out
    again = {row.file: row for row in stored()}
    assert {file for file in first if first[file] == again[file]} == {"ada/middle.py", "cy/homework.py"}
    submit(FLOOR, "homework/bob/middle.py")  # as it was
    assert "4 results kept from before" in judge("class", "homework").err
    there = ("ada/middle.py", "bob/middle.py", "cy/homework.py", "ada/middle.py")
    assert [row.digest for row in stored()] == [first[file].digest for file in there]
    with ResultStore.read(Path("homework.judge.sqlite3")) as store:
        assert len({row.digest for row in store.every() if row.student == "bob"}) == 2
    before = {row.file: row.at for row in stored()}
    assert judge("class", "homework", "--again", "ada").status == 1
    after = {row.file: row.at for row in stored()}
    assert [file for file in before if before[file] != after[file]] == ["ada/middle.py"]
    with monkeypatch.context() as other:
        other.setattr(model, "code_key", lambda: "else")
        told = judge("class", "homework").err
    assert told.count("\n") == 2
    assert "4 judged anew, because of the judge (" in told
    assert "+else)" in told


def test_parts_put_together_are_the_plain_run(judge, homework, submit):
    for at in (2, 3):
        submit(WRONG.format(at), f"homework/s{at}/middle.py")
    assert judge("class", "homework").status == 3
    Path("homework.judge.sqlite3").rename("plain.sqlite3")
    for number in (1, 2, 3):
        assert judge("class", "homework", "--shard", f"{number}/3").status in (0, 1, 3)
    parts = [f"homework.judge.{number}-of-3.sqlite3" for number in (1, 2, 3)]
    assert sum(len(stored(part)) for part in parts) == 6
    assert all(len(stored(part)) < 6 for part in parts)
    shown = judge("class", "homework", "--merge", *parts)
    assert shown.status == 3
    assert "6 rows merged from 3 files" in shown.err
    assert "5 results kept from before" in shown.err  # the sixth cannot be read
    assert untimed(stored()) == untimed(stored("plain.sqlite3"))
    for words, said in REFUSED_PARTS.items():
        refused = judge("class", "homework", *words.split())
        assert (refused.status, refused.err) == (2, f"judge: {said}\n")


REFUSED_PARTS = {
    "--shard 0/3": "'0/3' is not a part; write 3/20 for the third of 20, from 1/20 to 20/20",
    "--shard 1/3 --csv a.csv": "--shard and --csv contradict each other; leave one out",
    "--shard 1/3 --merge x": "--shard and --merge contradict each other; leave one out",
    "--merge": "--merge takes files; name those that 'judge class --shard' wrote",
}


def untimed(found):
    """Rows as JSON, without their times and the worker."""
    plain = []
    for row in found:
        done = replace(row.done, result=lasting(row.done.result), seconds=0, worker="")
        plain.append(replace(row, at=0, done=done))
    return plain


def started(*words):
    """The command as a process of its own, the first of its group."""
    return subprocess.Popen(
        [sys.executable, "-m", "judge", "class", "homework", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        start_new_session=True,
    )


def some_rows(least=1):
    """Wait until so many rows are kept."""
    for _ in range(6000):
        try:
            found = stored()
        except StoreError:
            found = []
        if len(found) >= least:
            return found
        time.sleep(0.01)
    raise AssertionError("no row is kept")


@pytest.mark.nightly
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_the_same_command_goes_on_after_any_end(judge, submit, how):
    sleepy = "import time\ntime.sleep(1)\n"
    for at in range(6):
        submit(f"{sleepy}\n{WRONG.format(at + 2)}", f"homework/s{at}/middle.py")
    process = started("-j", "2")
    some_rows()
    second = judge("class", "homework")
    assert (second.status, second.out) == (3, "")
    assert "another judge is writing to it; wait until it has ended" in second.err
    os.killpg(process.pid, how) if how == signal.SIGINT else process.kill()
    printed, said = process.communicate(timeout=120)
    kept = stored()
    assert 1 <= len(kept) < 6
    if how == signal.SIGINT:
        assert process.returncode == 130
        left = 6 - len(kept)
        assert f"{left} file{'s' * (left > 1)} left; the same command goes on" in said
        assert f"0 of {len(kept)} accepted, 6 students, 1 kata" in printed
        assert "Traceback" not in said
    ended = judge("class", "homework")
    assert f"{len(kept)} result{'s' * (len(kept) != 1)} kept from before" in ended.err
    final = stored()
    assert len(final) == len({row.key for row in final}) == 6
    assert {row.key: row.at for row in kept}.items() <= {row.key: row.at for row in final}.items()
    assert {row.result.verdict.value for row in final} == {"WA"}


@pytest.mark.nightly
def test_a_worker_that_is_killed_loses_no_row_and_doubles_none(submit):
    for at in range(6):
        submit(f"import time\ntime.sleep(1)\n{WRONG.format(at + 2)}", f"homework/s{at}/middle.py")
    with started("-j", "2", "--json") as process:
        first = process.stdout.readline()
        os.kill(int(json.loads(first)["worker"].rpartition(":")[2]), signal.SIGKILL)  # at its next file
        rest = process.stdout.read()
    found = [json.loads(line) for line in (first + rest).splitlines()]
    files = [(row["file"], row["verdict"]) for row in found if "student" in row]
    assert process.returncode == 1
    assert sorted(files) == [(f"s{at}/middle.py", "WA") for at in range(6)]
    assert len({row["worker"] for row in found if "student" in row}) == 3
    with ResultStore.read(Path("homework.judge.sqlite3")) as store:
        assert sorted(row.file for row in store.every()) == sorted(file for file, _ in files)


SBATCH = """#!/bin/sh
for word in "$@"; do command=$word; done
while [ "$task" != 20 ]; do task=$((task + 1)); SLURM_ARRAY_TASK_ID=$task sh -c "$command"; done
"""


def test_the_manuals_recipe_asks_for_each_part_once(tmp_path):
    blocks = page("class").text.split("```")[1::2]
    (command,) = [block.partition("\n")[2] for block in blocks if "sbatch" in block]
    for name, text in (("sbatch", SBATCH), ("judge", '#!/bin/sh\necho "$@" >> asked\n')):
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    settings = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    subprocess.run(["sh", "-e", "-c", command], check=True, env=settings, timeout=60)
    asked = (tmp_path / "asked").read_text().splitlines()
    assert asked == [f"class homework --shard {number}/20" for number in range(1, 21)]
