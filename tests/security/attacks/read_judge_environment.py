"""Read the environment of the judge."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(open(f"/proc/{target['judge_pid']}/environ", "rb").read()))
except OSError as error:
    print("held", error)
