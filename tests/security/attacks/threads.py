"""Start threads without bound."""

import json
import sys
import threading

target = json.load(sys.stdin)

release = threading.Event()
threading.stack_size(64 * 1024)
started = []
try:
    while len(started) < 300:
        started.append(threading.Thread(target=release.wait, daemon=True))
        started[-1].start()
except (RuntimeError, MemoryError) as error:
    started.pop()
    print("held", len(started), error)
else:
    print("BREACH", len(started))
release.set()
