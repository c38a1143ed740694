"""See whether the judge could be signalled."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.kill(target["judge_pid"], 0)
    print("BREACH")
except OSError as error:
    print("held", error)
