"""Connect over TCP."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    socket.create_connection(("127.0.0.1", target["port"]), 1).close()
    print("BREACH")
except OSError as error:
    print("held", error)
