"""Find out that a file exists, and its size."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", os.stat(target["secret"]).st_size)
except OSError as error:
    print("held", error)
