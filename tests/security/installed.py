"""Runs in a Python that has the judge installed: a submission looks for the reference solution to `count`.

`installed.py LEVEL [FIELD…]` writes one JSON object: by which paths the submission could read it or list its
folder, or the judge's refusal. LEVEL may be `best`. FIELDs of what is visible are emptied before, as a fault
of ours might leave them.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import judge
from judge.errors import JudgeError
from judge.sandbox import Containment, visible
from judge.sandbox.boundary import Limits
from judge.sandbox.visible import Visible

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)
SOURCE = Path(__file__).parent / "submissions" / "look_for_solution.py"


def _told() -> list[str]:
    """Every name that this Python has for the places of modules; a submission could guess them."""
    names = [entry for entry in sys.path if entry]
    package = Path(judge.__file__).parent
    return [*names, str(package), str(package.parent), str(package.resolve().parent)]


def _tried(level: str | None) -> dict[str, object]:
    try:
        with Containment(level)(SOURCE.read_bytes(), SOURCE.name) as box:
            result = box.run_program(json.dumps(_told()).encode(), LIMITS)
            held = box.isolation
    except JudgeError as error:
        return {"refused": str(error)}
    found = result.stdout.decode(errors="replace").splitlines()
    errors = result.stderr.decode(errors="replace")
    return {"stop": result.stop.value, "isolation": held, "found": found, "errors": errors}


def main(level: str, forgotten: list[str]) -> None:
    whole = visible.visible

    def forgetful(*arguments: Any, **options: Any) -> Visible:
        return whole(*arguments, **options)._replace(**dict.fromkeys(forgotten, ()))

    visible.visible = forgetful  # type: ignore[assignment]
    print(json.dumps(_tried(None if level == "best" else level)))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
