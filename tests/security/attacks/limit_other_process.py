"""Change the limits of another process."""

import json
import resource
import sys

target = json.load(sys.stdin)
try:
    resource.prlimit(target["victim_pid"], resource.RLIMIT_NOFILE, (64, 64))
    print("BREACH")
except OSError as error:
    print("held", error)
