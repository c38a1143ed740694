"""Change how it is scheduled."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))
    print("BREACH")
except OSError as error:
    print("held", error)
