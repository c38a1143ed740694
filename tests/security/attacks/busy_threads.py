"""Work in several threads at once."""

import threading


def work():
    while True:
        hash(b"x" * 1000)


for _ in range(4):
    threading.Thread(target=work).start()
