"""Stop the process that watches."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.kill(os.getppid(), 0)
    print("BREACH")
except OSError as error:
    print("held", error)
