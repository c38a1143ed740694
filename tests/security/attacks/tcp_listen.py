"""Listen on TCP."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    socket.create_server(("127.0.0.1", 0)).close()
    print("BREACH")
except OSError as error:
    print("held", error)
