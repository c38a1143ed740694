"""Kill another process."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.kill(target["victim_pid"], 15)
    print("BREACH")
except OSError as error:
    print("held", error)
