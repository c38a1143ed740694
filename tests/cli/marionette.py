"""A page in headless Firefox that is asked and told by its own protocol, over a socket."""

from __future__ import annotations

import json
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from devtools import NAMED, SECONDS, Tab

FIREFOX = next(filter(None, map(shutil.which, ("firefox", "firefox-esr"))), None)
_PREFERENCES = {
    "marionette.port": 0,
    "network.dns.localDomains": NAMED,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
}


class FirefoxTab(Tab):
    """One page; it does not tell what it complained of."""

    def __init__(self, port: int) -> None:
        self._socket = socket.create_connection(("127.0.0.1", port), timeout=SECONDS)
        self._file, self._number = self._socket.makefile("rb"), 0
        self._read()  # its greeting
        self._call("WebDriver:NewSession")
        self._call("WebDriver:SetTimeouts", script=int(1000 * SECONDS))

    def _read(self) -> Any:
        digits = b""
        while (byte := self._file.read(1)) != b":":
            assert byte, "Firefox has closed the connection"
            digits += byte
        return json.loads(self._file.read(int(digits)))

    def _call(self, method: str, **params: Any) -> Any:
        self._number += 1
        text = json.dumps([0, self._number, method, params]).encode()
        self._socket.sendall(b"%d:%s" % (len(text), text))
        _, _, fault, value = self._read()
        assert fault is None, fault
        return (value or {}).get("value")

    def ask(self, expression: str) -> Any:
        """See `Tab.ask`."""
        return self._call("WebDriver:ExecuteScript", script=f"return (async () => ({expression}))()", args=[])

    def go(self, address: str) -> None:
        """See `Tab.go`."""
        self._call("WebDriver:Navigate", url=address)

    def close(self) -> None:
        self._file.close()
        self._socket.close()


@contextmanager
def firefox(folder: Path) -> Iterator[Tab]:
    """A page of a browser of its own, whose profile is in that folder."""
    assert FIREFOX is not None
    folder.mkdir()
    lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in _PREFERENCES.items()]
    (folder / "user.js").write_text("".join(lines))
    command = [FIREFOX, "--headless", "--marionette", "--no-remote", "--profile", str(folder)]
    browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        port, end = folder / "MarionetteActivePort", time.monotonic() + SECONDS
        while not (port.is_file() and port.read_text()) and time.monotonic() < end:
            time.sleep(0.1)
        tab = FirefoxTab(int(port.read_text()))
        yield tab
        tab.close()
    finally:
        browser.terminate()
        browser.wait(20)
