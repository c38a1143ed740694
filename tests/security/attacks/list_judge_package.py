"""List the judge's own folder."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", len(os.listdir(target["judge_folder"])))
except OSError as error:
    print("held", error)
