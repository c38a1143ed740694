"""List the folder of expected answers."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", os.listdir(target["folder"]))
except OSError as error:
    print("held", error)
