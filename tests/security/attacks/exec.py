"""Become another program."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.execv("/bin/echo", ["echo", "BREACH"])
except OSError as error:
    print("held", error)
