"""Start another program."""

import json
import subprocess
import sys

target = json.load(sys.stdin)
try:
    subprocess.run(["/bin/echo"], check=True, stdout=subprocess.DEVNULL)
    print("BREACH")
except OSError as error:
    print("held", error)
