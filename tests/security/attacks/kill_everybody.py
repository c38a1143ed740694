"""See whether everybody could be signalled."""

import os

try:
    os.kill(-1, 0)
    print("BREACH")
except OSError as error:
    print("held", error)
