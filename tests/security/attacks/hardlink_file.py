"""Make a hard link."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    os.link(target["victim"], os.path.join(target["folder"], "made-hard-link"))
    print("BREACH")
except OSError as error:
    print("held", error)
