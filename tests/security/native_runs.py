"""Compiles and runs programs as whoever starts it: `native_runs.py LEVEL < pickled recipes and sources`.

Writes one JSON object for each: what it printed, or why it did not come so far.
"""

from __future__ import annotations

import base64
import json
import pickle
import sys

from native_driver import LIMITS, NoStore

from judge.errors import JudgeError
from judge.sandbox import Boxes
from judge.sandbox.native import NativeBox

if __name__ == "__main__":
    for name, order in pickle.loads(base64.b64decode(sys.stdin.read())):
        found = {"name": name}
        try:
            with NativeBox(lambda order=order: order, Boxes(sys.argv[1]), NoStore()) as box:
                fault = box.inspect().fault
                if fault is None:
                    done = box.run_program(b"19 23\n", LIMITS)
                    found |= {"output": done.stdout.decode(), "detail": done.detail, "level": box.isolation}
                else:
                    found["fault"] = fault.message
        except JudgeError as error:
            found["broken"] = str(error)
        print(json.dumps(found), flush=True)
