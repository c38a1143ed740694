"""Leave a process behind that goes on working."""

import json
import os
import signal
import sys
import time

target = json.load(sys.stdin)

try:
    child = os.fork()
except OSError as error:
    print("held", error)
else:
    if child == 0:
        os.setsid()
        if os.fork():
            os._exit(0)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        for _ in range(60):
            with open(os.path.join(target["folder"], "heartbeat"), "a") as file:
                file.write("x")
            time.sleep(0.05)
        os._exit(0)
    os.waitpid(child, 0)
    time.sleep(0.2)
    print("started")
