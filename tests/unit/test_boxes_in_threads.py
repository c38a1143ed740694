"""Several boxes at once, each in its own thread: none needs the main thread or shares with another."""

from __future__ import annotations

import os
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import pytest
from sandboxed import LIMITS, children, limits, require

from judge.sandbox import LEVELS, Stop, open_box

pytestmark = pytest.mark.slow

THREADS = 4


@pytest.mark.parametrize("level", LEVELS)
def test_four_threads_each_judge_in_their_own_box(level):
    require(level)
    before = children()
    together = threading.Barrier(THREADS, timeout=60)

    def judge(place):
        source = f"""
import os
def f(n):
    if n == 1: os._exit(3)
    if n == 3:
        while True: pass
    return [{place}, n]
print({place}, input())
"""
        together.wait()
        with open_box(source.encode(), f"{place}.py", level=level) as box:
            together.wait()  # all are open now
            assert box.inspect().defines("f")
            printed = box.run_program(b"%d" % place, LIMITS)
            assert (printed.stop, printed.stdout) == (Stop.ANSWERED, f"{place} {place}\n".encode())
        with open_box(source.partition("print")[0].encode(), f"{place}.py", level=level) as box:
            replies = []
            while len(replies) < 5:
                rest = [(n,) for n in range(len(replies), 5)]
                replies += box.call("f", rest, limits(cpu_seconds=0.1)).replies
            assert box.isolation == level
        return [(reply.stop, reply.answer) for reply in replies]

    with ThreadPoolExecutor(THREADS) as pool:
        for place, replies in enumerate(pool.map(judge, range(THREADS))):
            assert replies == [
                (Stop.ANSWERED, [place, 0]),
                (Stop.EXITED, None),
                (Stop.ANSWERED, [place, 2]),
                (Stop.CPU, None),
                (Stop.ANSWERED, [place, 4]),
            ]
    assert children() == before


@pytest.mark.parametrize("level", LEVELS)
def test_a_box_outlives_the_thread_that_opened_it(level):
    require(level)
    opened = []

    def judge():
        opened.append(stack.enter_context(open_box(b"print(input())", "my.py", level=level)))
        assert opened[0].run_program(b"1", LIMITS).stdout == b"1\n"

    with ExitStack() as stack:
        thread = threading.Thread(target=judge)
        thread.start()
        thread.join()
        time.sleep(0.1)  # for what would end with the thread
        assert opened[0].run_program(b"2", LIMITS).stdout == b"2\n"


def test_a_box_that_falls_to_a_lower_level_before_it_is_entered_makes_its_calls(tmp_path, monkeypatch):
    require("strong")
    broken = tmp_path / "bwrap"
    broken.write_text("#!/bin/sh\necho No permissions to create a new namespace >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    box = open_box(b"def f(n):\n    return n\n", "my.py")
    time.sleep(0.5)  # until bubblewrap has ended
    with box:
        replies = box.call("f", [(1,), (2,)], LIMITS).replies
        assert box.isolation == "strong"
    assert [(reply.stop, reply.answer) for reply in replies] == [(Stop.ANSWERED, 1), (Stop.ANSWERED, 2)]
