"""Truncate a file."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.truncate(target["victim"], 0)
    print("BREACH")
except OSError as error:
    print("held", error)
