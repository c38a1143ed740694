"""Move a file."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.rename(target["victim"], target["victim"] + ".moved")
    print("BREACH")
except OSError as error:
    print("held", error)
