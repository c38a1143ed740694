"""Print too much and hide the failure."""

import os

try:
    while True:
        os.write(1, b"x" * 65536)
except OSError:
    os._exit(0)
