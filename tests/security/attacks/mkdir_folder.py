"""Make a folder."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.mkdir(os.path.join(target["folder"], "made-folder"))
    print("BREACH")
except OSError as error:
    print("held", error)
