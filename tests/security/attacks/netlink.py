"""Open a netlink socket."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 0).close()
    print("BREACH")
except OSError as error:
    print("held", error)
