"""Runs the attacks of native_table.py as whoever starts it: `native_driver.py LEVEL < recipe and names`.

LEVEL is an isolation level, or `none` for the positive control: the program compiled and run as it is, in a
temporary folder. Writes one JSON object for each attack.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from driver import aimed, targets
from native_table import BOMBS, COMPILE, HEAD, RUN

from judge.errors import JudgeError
from judge.sandbox import Boxes
from judge.sandbox.boundary import Limits
from judge.sandbox.native import NativeBox
from judge.sandbox.recipe import Recipe, Sources

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)
CONTROL_SECONDS = 20


class NoStore:
    """Keeps nothing."""

    def artifact(self, key):
        return None

    def idle(self, key):
        return None

    def keep_artifact(self, key, files):
        pass

    def keep_idle(self, key, usage):
        pass


def source_of(name: str, target: dict[str, Any]) -> str:
    if name in RUN:
        source = HEAD.replace("BODY", RUN[name])
    else:
        source = COMPILE[name][0] if name in COMPILE else BOMBS[name][1]
    for key, value in target.items():
        source = source.replace(f"@{key}@", str(value))
    return source


def contained(recipe: Recipe, name: str, level: str, target: dict[str, Any]) -> dict[str, Any]:
    file = "solution.c"
    order = recipe, Sources(((file, source_of(name, target).encode()),), file)
    try:
        with NativeBox(lambda: order, Boxes(level), NoStore(), idle=False) as box:
            fault = box.inspect().fault
            if fault:
                return {"name": name, "fault": fault.message}
            done = box.run_program(b"", LIMITS)
    except JudgeError as error:
        return {"name": name, "broken": str(error)}
    out = done.stdout[:500].decode(errors="replace")
    return {"name": name, "output": out, "stop": done.stop.value, "detail": done.detail}


def bare(name: str, target: dict[str, Any]) -> dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="judge-control-") as folder:
        path = Path(folder, "solution.c")
        path.write_text(source_of(name, target))
        command = ["gcc", "-O2", "-static", "-o", "main", str(path), "-lm"]
        made = subprocess.run(
            command, cwd=folder, capture_output=True, text=True, timeout=CONTROL_SECONDS, check=False
        )
        if made.returncode:
            return {"name": name, "fault": made.stderr[:2000]}
        done = subprocess.run(
            ["./main"], cwd=folder, capture_output=True, timeout=CONTROL_SECONDS, check=False
        )
    return {"name": name, "output": done.stdout[:500].decode(errors="replace")}


def main(level: str) -> None:
    given = json.load(sys.stdin)
    fields = {
        key: tuple(value) if isinstance(value, list) else value for key, value in given["recipe"].items()
    }
    fields["empty"] = (fields["empty"][0], fields["empty"][1].encode())
    recipe = Recipe(**fields)
    with targets() as target:
        for name in given["names"]:
            with aimed(target) as each:
                each = {**each, "python": os.path.realpath(sys.executable)}
                outcome = bare(name, each) if level == "none" else contained(recipe, name, level, each)
            print(json.dumps(outcome), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
