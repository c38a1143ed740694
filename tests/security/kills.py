"""Starts `judge run` again and again, ends it at a random moment, and looks who is alive a second later.

    kills.py COUNT SEED LEVEL FILE…     prints one JSON object: how many of each end, and who was left

Whatever loses its parent becomes a child of this process, so that nothing of the tree can hide.
"""

from __future__ import annotations

import ctypes
import json
import os
import random
import signal
import subprocess
import sys
import time

from processes import below

PR_SET_CHILD_SUBREAPER = 36
LONGEST = 2.5  # seconds before the end comes
LATER = 1.0
ENDS = (signal.SIGKILL, signal.SIGINT)


def reap() -> None:
    """Take in what has ended."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        return


def end_once(words: list[str], chance: random.Random) -> tuple[str, str | None]:
    """How it was ended, and what was left of it, if anything."""
    number, moment = chance.choice(ENDS), chance.uniform(0.0, LONGEST)
    judge = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(moment)
    tree = {pid: process.name for pid, process in below(judge.pid).items()}
    if judge.poll() is not None:
        return "ended before", None
    judge.send_signal(number)
    judge.wait(30)
    until = time.monotonic() + LATER
    while (left := below(os.getpid())) and time.monotonic() < until:
        reap()
        time.sleep(0.02)
    reap()
    if left:
        for pid in left:
            os.kill(pid, signal.SIGKILL)
        return number.name, f"{number.name} after {moment:.3f} s of {tree} left {[*left.values()]}"
    return number.name, None


def main(count: int, seed: int, level: str, files: list[str]) -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # what is started in the background ignores it
    libc = ctypes.CDLL(None, use_errno=True)
    zero = ctypes.c_ulong(0)
    if libc.prctl(PR_SET_CHILD_SUBREAPER, ctypes.c_ulong(1), zero, zero, zero):
        raise OSError(ctypes.get_errno(), "prctl")
    words = [sys.executable, "-m", "judge", "run", "middle", *files, "--json", "--no-history", "-j", "2"]
    chance = random.Random(seed)
    ends: dict[str, int] = {}
    survivors = []
    for _ in range(count):
        how, left = end_once([*words, "--isolation", level], chance)
        ends[how] = ends.get(how, 0) + 1
        survivors += [left] if left else []
    print(json.dumps({"ends": ends, "survivors": survivors}))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3], sys.argv[4:])
