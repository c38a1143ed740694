"""Runs the attacks of `judge doctor --attack` as whoever starts it: `doctors_attacks.py LEVEL`.

LEVEL is an isolation level, or `none` for the positive control: each in a plain interpreter, whose memory is
bounded. Writes one JSON object for each.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import judge.sandbox
from judge.sandbox import Boxes
from judge.sandbox.attacking import attacked, targets
from judge.sandbox.attacks import ATTACKS, Attack
from judge.sandbox.boundary import Stop

PACKS = [Path(judge.sandbox.__file__).parent]


def bare(attack: Attack, target: dict[str, Any]) -> dict[str, Any]:
    """What comes of it without containment."""
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as written:
        given.write(json.dumps(target).encode())
        given.seek(0)
        reading, writing = os.pipe()
        os.set_inheritable(reading, True)
        process = subprocess.Popen(
            [sys.executable, "-I", "-c", attack.source.decode()],
            stdin=given,
            stdout=written,
            stderr=written,
            cwd=target["folder"],
            close_fds=False,
            start_new_session=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (2 << 30, resource.RLIM_INFINITY)),
        )
        os.close(reading)
        os.close(writing)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        size = os.fstat(written.fileno()).st_size
        written.seek(max(0, size - 300))
        output = written.read().decode(errors="replace")
    works = {
        Stop.MEMORY: usage.ru_maxrss > 128 << 10,
        Stop.OUTPUT: size > 1 << 20,
        Stop.CPU: usage.ru_utime + usage.ru_stime > 1.0,
        Stop.WALL: "BREACH" in output,
    }
    worked = works[attack.ends[0]] if attack.ends else "BREACH" in output
    return {"name": attack.name, "works": worked, "how": output}


def main(level: str) -> None:
    if level == "none":
        with targets(PACKS) as target:
            for attack in ATTACKS:
                print(json.dumps(bare(attack, target)), flush=True)
    else:
        for each in attacked(Boxes(level), PACKS):
            print(json.dumps({"name": each.attack.name, "held": each.held, "how": each.how}), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
