"""Read the judge's own code."""

import json
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(open(target["judge_file"]).read()))
except OSError as error:
    print("held", error)
