"""Connect to an abstract unix socket."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    socket.socket(socket.AF_UNIX).connect("\0" + target["unix_abstract"])
    print("BREACH")
except OSError as error:
    print("held", error)
