"""Read the judge's memory through /proc."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(open(f"/proc/{target['judge_pid']}/maps").read()))
except OSError as error:
    print("held", error)
