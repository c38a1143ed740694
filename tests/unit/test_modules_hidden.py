"""The modules that are installed for Python are Python's: a compiled program sees none of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from native import ran

from judge.sandbox import Boxes, levels
from judge.sandbox.boundary import Limits, Stop
from judge.sandbox.concealed import SITE_NAMES
from judge.sandbox.roots import find_roots

LEVELS = [level.name for level in levels() if level.available and level.name != "limits"]
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
    return [
        entry for entry in find_roots().searched if Path(entry).name in SITE_NAMES and Path(entry).is_dir()
    ]


@pytest.mark.slow
@pytest.mark.parametrize("level", LEVELS)
def test_a_compiled_program_lists_none(level):
    run = ran("lists.c", LISTS, "\n".join([*sites(), ""]).encode(), level=level)
    assert (run.stop, run.stdout) == (Stop.ANSWERED, b""), run


@pytest.mark.slow
@pytest.mark.parametrize("level", LEVELS)
def test_a_python_program_has_them(level):
    with Boxes(level)(IMPORTS, "main.py") as box:
        run = box.run_program(b"1 2\n", LIMITS)
    assert run.stdout == b"msgspec 3\n", run
