"""Change its priority."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.setpriority(os.PRIO_PROCESS, 0, 5)
    print("BREACH")
except OSError as error:
    print("held", error)
