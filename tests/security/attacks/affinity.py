"""Choose its processors."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.sched_setaffinity(0, os.sched_getaffinity(0))
    print("BREACH")
except OSError as error:
    print("held", error)
