"""The modules that a submission finds: what a fork server imports ahead, what a compiled program sees."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from native import ran

from judge.sandbox import Containment
from judge.sandbox.available import levels_here
from judge.sandbox.boundary import Limits, Stop
from judge.sandbox.inside.source import ALLOWED
from judge.sandbox.visible import SITE_NAMES, visible

LEVELS = [level.name for level in levels_here() if level.available and level.name != "limits"]
LIMITS = Limits(5.0, 20.0, 512 << 20, 1 << 20)
LISTS = """
#include <dirent.h>
#include <stdio.h>
#include <string.h>
int main(void) {
    char path[4096];
    while (fgets(path, sizeof path, stdin)) {
        path[strcspn(path, "\\n")] = 0;
        DIR *folder = opendir(path);
        struct dirent *entry;
        while (folder && (entry = readdir(folder)))
            if (entry->d_name[0] != '.') puts(path), puts(entry->d_name);
    }
}
"""
IMPORTS = b"import msgspec\nprint(msgspec.__name__, sum(map(int, input().split())))\n"


def sites():
    return [entry for entry in visible().searched if Path(entry).name in SITE_NAMES and Path(entry).is_dir()]


@pytest.mark.slow
@pytest.mark.parametrize("level", LEVELS)
def test_a_compiled_program_lists_none(level):
    run = ran("lists.c", LISTS, "\n".join([*sites(), ""]).encode(), level=level)
    assert (run.stop, run.stdout) == (Stop.ANSWERED, b""), run


@pytest.mark.slow
@pytest.mark.parametrize("level", LEVELS)
def test_a_python_program_has_them(level):
    with Containment(level)(IMPORTS, "main.py") as box:
        run = box.run_program(b"1 2\n", LIMITS)
    assert run.stdout == b"msgspec 3\n", run


STANDARD = sorted(name for name in ALLOWED if name.partition(".")[0] in sys.stdlib_module_names)
WATCH = """
import _signal, _thread, atexit, builtins, os, sys, threading, warnings
def is_open(number):
    try:
        return os.fstat(number).st_ino
    except OSError:
        return 0
def mask():
    old = os.umask(0)
    os.umask(old)
    return old
def state():
    return {
        "signal handlers": [_signal.getsignal(number) for number in range(1, _signal.NSIG)],
        "open files": [is_open(number) for number in range(64)],
        "threads": _thread._count(),
        "exit functions": (atexit._ncallbacks(), len(threading._threading_atexits)),
        "environment": dict(os.environ),
        "hooks": (sys.excepthook, sys.displayhook, sys.unraisablehook, threading.excepthook, sys.gettrace()),
        "imports": (sys.path[:], sys.meta_path[:], sys.path_hooks[:]),
        "folder": (os.getcwd(), mask()),
        "recursion": sys.getrecursionlimit(),
        "streams": (sys.stdin, sys.stdout, sys.stderr),
        "builtins": sorted(vars(builtins)),
        "warnings": warnings.filters[:],
    }
for name in sys.argv[1:]:
    before = state()
    __import__(name)
    after = state()
    for what in before:
        if before[what] != after[what]:
            print(name, "changes", what)
"""


# Each only adds an exit function: it flushes handlers, or lets go of readline's completer (Python 3.13).
HARMLESS = {"logging changes exit functions", "doctest changes exit functions"}


def test_nothing_happens_when_they_are_imported():
    command = [sys.executable, "-s", "-P", "-S", "-B", "-c", WATCH, *STANDARD]
    run = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    assert set(run.stdout.splitlines()) - HARMLESS == set()
