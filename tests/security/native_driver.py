"""Compiles and runs programs as whoever starts it: `native_driver.py LEVEL < pickled orders`.

An order is a name, a recipe and a source, in which `@name@` stands for a target of driver.py. LEVEL is an
isolation level, or `none` for the positive control: C, compiled and run as it is, in a temporary folder.
Writes one JSON object for each: what it printed, or why it did not come so far.
"""

from __future__ import annotations

import base64
import json
import os
import pickle
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from driver import aimed, targets

from judge.errors import JudgeError
from judge.sandbox import Containment
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


def contained(recipe: Recipe, source: str, level: str) -> dict[str, Any]:
    file = recipe.empty[0]
    order = recipe, Sources(((file, source.encode()),), file)
    try:
        with NativeBox(lambda: order, Containment(level), NoStore(), idle=False) as box:
            fault = box.inspect().fault
            if fault:
                return {"fault": fault.message}
            done = box.run_program(b"19 23\n", LIMITS)
            held = box.isolation
    except JudgeError as error:
        return {"broken": str(error)}
    out = done.stdout[:500].decode(errors="replace")
    return {"output": out, "stop": done.stop.value, "detail": done.detail, "level": held}


def bare(source: str) -> dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="judge-control-") as folder:
        Path(folder, "solution.c").write_text(source)
        command = ["gcc", "-O2", "-static", "-o", "main", "solution.c", "-lm"]
        made = subprocess.run(
            command, cwd=folder, capture_output=True, text=True, timeout=CONTROL_SECONDS, check=False
        )
        if made.returncode:
            return {"fault": made.stderr[:2000]}
        done = subprocess.run(
            ["./main"], cwd=folder, capture_output=True, timeout=CONTROL_SECONDS, check=False
        )
    return {"output": done.stdout[:500].decode(errors="replace")}


def main(level: str) -> None:
    with targets() as target:
        for name, recipe, source in pickle.loads(base64.b64decode(sys.stdin.read())):
            with aimed(target) as each:
                for key, value in {**each, "python": os.path.realpath(sys.executable)}.items():
                    source = source.replace(f"@{key}@", str(value))
                outcome = bare(source) if level == "none" else contained(recipe, source, level)
            print(json.dumps({"name": name, **outcome}), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
