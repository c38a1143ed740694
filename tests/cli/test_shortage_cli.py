"""A shortage on the judge's own side: one line with a remedy, one submission, status 3."""

from __future__ import annotations

import errno
import json
import threading

import pytest
from cli_support import FLOOR, MEAN

from judge.cli.commands import list as list_module
from judge.judging import session

SHORTAGES = [
    (OSError(errno.EMFILE, "Too many open files"), "the judge has no file descriptor left; use a smaller -j"),
    (OSError(errno.ENFILE, "Too many"), "the system has no file descriptor left; use a smaller -j"),
    (MemoryError(), "there is no memory left; use a smaller -j"),
    (RuntimeError("can't start new thread"), "no further process or thread can be started; use a smaller -j"),
    (OSError(errno.EFBIG, "File too large"), "a file may not become as large as it must; raise the limit"),
]


@pytest.mark.parametrize(("fault", "line"), SHORTAGES)
def test_a_shortage_costs_one_submission_and_the_rest_are_judged(fault, line, judge, submit, monkeypatch):
    real = session.run_in

    def short(box, problem, data, source, name, **how):
        if name == "team/b.py":
            raise fault
        return real(box, problem, data, source, name, **how)

    monkeypatch.setattr(session, "run_in", short)
    for name in ("a", "b", "c"):
        submit(MEAN, f"team/{name}.py")
    ended = judge("run", "middle", "team", "--json")
    results = [json.loads(row) for row in ended.lines]
    assert [result["verdict"] for result in results] == ["AC", "JE", "AC"]
    assert results[1]["failure"]["message"].startswith(line)
    assert (ended.status, ended.err) == (3, "")


@pytest.mark.parametrize(("fault", "line"), SHORTAGES)
def test_a_shortage_anywhere_else_is_one_line_with_its_remedy(fault, line, judge, monkeypatch):
    def short(_folders):
        raise fault

    monkeypatch.setattr(list_module, "sound_problems", short)
    ended = judge("list")
    assert (ended.status, ended.out) == (3, "")
    assert ended.err.startswith(f"judge: {line}")
    assert ended.err.count("\n") == 1


def test_a_judge_without_a_thread_to_spare_judges_one_after_the_other(judge, submit, monkeypatch):
    """Where no thread but the one that starts containers can be had."""
    real = threading.Thread.start

    def start(thread):
        if "_serve" not in thread.name:
            raise RuntimeError("can't start new thread")
        real(thread)

    monkeypatch.setattr(threading.Thread, "start", start)
    files = [submit(source, name) for source, name in ((MEAN, "a.py"), (FLOOR, "b.py"), (MEAN, "c.py"))]
    ended = judge("run", "middle", *files, "--json")
    assert [json.loads(row)["verdict"] for row in ended.lines] == ["AC", "WA", "AC"]
    assert (ended.status, ended.err) == (1, "")
    ended = judge("run", "middle", *files, "--json", "-j", "3")
    for row in ended.lines:
        assert json.loads(row)["failure"]["message"].startswith(SHORTAGES[3][1])
    assert ended.status == 3
