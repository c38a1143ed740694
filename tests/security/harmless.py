"""Runs the attacks of attacks.py as whoever starts it: `harmless.py LEVEL`.

LEVEL is an isolation level, or `none` for the positive control. Writes one JSON object for each.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from attacking import attacked, targets
from attacks import ATTACKS
from driver import bare

import judge.sandbox
from judge.sandbox import Containment
from judge.sandbox.boundary import Stop

PACKS = [Path(judge.sandbox.__file__).parent]


def main(level: str) -> None:
    if level == "none":
        with targets(PACKS) as target:
            for attack in ATTACKS:
                found = bare(attack.name, attack.source.decode(), target, file_bytes=1 << 30)
                breach = "BREACH" in found["output"]
                works = {
                    Stop.MEMORY: found["peak"] > 128 << 20,
                    Stop.OUTPUT: found["printed"] > 1 << 20,
                    Stop.CPU: found["cpu"] > 1.0,
                }
                worked = works.get(attack.ends[0], breach) if attack.ends else breach
                row = {"name": attack.name, "works": worked, "how": found["output"][-300:]}
                print(json.dumps(row), flush=True)
    else:
        for each in attacked(Containment(level), PACKS):
            print(json.dumps({"name": each.name, "held": each.held, "how": each.how}), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
