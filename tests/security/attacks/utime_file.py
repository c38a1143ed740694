"""Change a file's times."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.utime(target["victim"], (1, 1))
    print("BREACH")
except OSError as error:
    print("held", error)
