"""Connect to a unix socket."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    socket.socket(socket.AF_UNIX).connect(target["unix_stream"])
    print("BREACH")
except OSError as error:
    print("held", error)
