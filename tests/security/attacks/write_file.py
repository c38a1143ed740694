"""Write a new file."""

import json
import os
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", open(os.path.join(target["folder"], "new.txt"), "w").write("x"))
except OSError as error:
    print("held", error)
