"""Fork."""

import json
import os
import sys

target = json.load(sys.stdin)

try:
    child = os.fork()
except OSError as error:
    print("held", error)
else:
    if child == 0:
        os._exit(0)
    os.waitpid(child, 0)
    print("BREACH")
