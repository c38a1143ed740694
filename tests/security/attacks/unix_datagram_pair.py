"""Reach a unix socket by name from a datagram pair."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    pair = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
    print("BREACH", pair[0].sendto(b"x", target["unix_datagram"]))
except OSError as error:
    print("held", error)
