"""Delete a file."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.unlink(target["victim"])
    print("BREACH")
except OSError as error:
    print("held", error)
