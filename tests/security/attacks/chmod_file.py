"""Change a file's mode."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.chmod(target["victim"], 0o600)
    print("BREACH")
except OSError as error:
    print("held", error)
