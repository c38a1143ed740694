"""Change the working folder."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.chdir(target["folder"])
    print("BREACH")
except OSError as error:
    print("held", error)
