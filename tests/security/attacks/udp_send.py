"""Send a UDP packet."""

import json
import socket
import sys

target = json.load(sys.stdin)
try:
    print("BREACH", socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"x", ("127.0.0.1", 9)))
except OSError as error:
    print("held", error)
