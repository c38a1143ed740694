"""A page in headless Chromium that is asked and told by its own protocol, over two pipes."""

from __future__ import annotations

import json
import os
import select
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from chromium import CHROMIUM

SECONDS = 90.0
NAMED = "judge.test"  # this machine, as one of a network: a page from there is no secure context


class Tab:
    """A page of a browser. `faults` are what it complained of, `addresses` all that it or its workers asked
    for, both as far as the browser tells."""

    faults: Sequence[str] = ()
    addresses: Sequence[str] = ()

    def ask(self, expression: str) -> Any:
        """The value of a JavaScript expression, which may be a promise."""
        raise NotImplementedError

    def go(self, address: str) -> None:
        """Open an address, and wait until the page is there."""
        raise NotImplementedError

    def until(self, expression: str, seconds: float = SECONDS) -> Any:
        """Wait for an expression to be true; its value."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if found := self.ask(expression):
                return found
            time.sleep(0.1)
        raise AssertionError(f"never true: {expression}; {self.faults}")


class ChromiumTab(Tab):
    """One page of Chromium, which tells all."""

    def __init__(self, to: int, back: int) -> None:
        self._to, self._back, self._rest, self._number = to, back, b"", 0
        self.faults: list[str] = []
        self.addresses: list[str] = []
        target = self.call("Target.createTarget", session=None, url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", session=None, targetId=target, flatten=True)[
            "sessionId"
        ]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    def call(self, method: str, session: str | None = "", **params: Any) -> dict[str, Any]:
        """What the browser answers to a method of its protocol."""
        self._number += 1
        asked: dict[str, Any] = {"id": self._number, "method": method, "params": params}
        if session is not None:
            asked["sessionId"] = self._session
        os.write(self._to, json.dumps(asked).encode() + b"\0")
        for said in self._heard(SECONDS):
            if said.get("id") == self._number:
                assert "error" not in said, said["error"]
                return said["result"]
        raise AssertionError(f"{method} is not answered")

    def _heard(self, seconds: float) -> Iterator[dict[str, Any]]:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            while b"\0" in self._rest:
                first, self._rest = self._rest.split(b"\0", 1)
                said = json.loads(first)
                self._note(said)
                yield said
            if select.select([self._back], [], [], 0.2)[0]:
                self._rest += os.read(self._back, 1 << 20)

    def _note(self, said: dict[str, Any]) -> None:
        method, params = said.get("method", ""), said.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.faults.append(json.dumps(params["exceptionDetails"])[:500])
        if method == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.faults.append(f"{params['entry']['text']} {params['entry'].get('url', '')}")
        if method == "Network.requestWillBeSent":
            self.addresses.append(params["request"]["url"])

    def ask(self, expression: str) -> Any:
        """See `Tab.ask`."""
        found = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def go(self, address: str) -> None:
        """See `Tab.go`."""
        self.call("Page.navigate", url=address)
        self.until("document.readyState === 'complete'")


@contextmanager
def chromium(folder: Path) -> Iterator[ChromiumTab]:
    """A page of a browser of its own, whose profile is in that folder."""
    assert CHROMIUM is not None
    theirs, to = os.pipe()
    back, ours = os.pipe()
    command = [
        CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
        "--no-first-run",
        "--disable-background-networking", "--disable-component-update", f"--user-data-dir={folder}",
        "--remote-debugging-pipe", f"--host-resolver-rules=MAP {NAMED} 127.0.0.1",
    ]  # fmt: skip

    def pipes() -> None:
        os.dup2(theirs, 103)
        os.dup2(ours, 104)
        os.dup2(103, 3)
        os.dup2(104, 4)

    browser = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, close_fds=False, preexec_fn=pipes
    )
    os.close(theirs)
    os.close(ours)
    try:
        yield ChromiumTab(to, back)
    finally:
        browser.terminate()
        browser.wait(20)
        os.close(to)
        os.close(back)
