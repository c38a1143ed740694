"""Write into /tmp."""

import json
import os
import sys

target = json.load(sys.stdin)

path = f"/tmp/judge-attack-{os.getpid()}"
try:
    open(path, "w").close()
    os.unlink(path)
    print("BREACH")
except OSError as error:
    print("held", error)
