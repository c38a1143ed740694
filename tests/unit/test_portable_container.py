"""What other systems than Linux do without: packet sockets, memory files, the clock of another process."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

from judge.sandbox import container, open_box, parcels
from judge.sandbox.boundary import Limits, Stop

pytestmark = pytest.mark.slow

LIMITS = Limits(2.0, 6.0, 256 << 20, 1 << 20)
ELSEWHERE = {
    "judge.sandbox.inside.server": ("(~pid << 3) | 2", "1 << 20"),  # no such clock
    "judge.sandbox.inside.confine": ('LINUX = sys.platform == "linux"', "LINUX = False"),
}


@pytest.fixture
def unpacked_once() -> Iterator[None]:
    parcels._module.cache_clear()
    yield
    parcels._module.cache_clear()


@pytest.fixture
def plain_system(monkeypatch: pytest.MonkeyPatch, unpacked_once: None) -> None:
    monkeypatch.setattr(container, "PAIR", socket.SOCK_STREAM)
    monkeypatch.setattr(parcels, "_create", lambda _flags: parcels._unlinked())
    monkeypatch.setattr(container.parcels, "region", _unsealed_region)
    as_here = parcels._code_of

    def as_elsewhere(name: str) -> object:
        if name not in ELSEWHERE:
            return as_here(name)
        here, elsewhere = ELSEWHERE[name]
        source = Path(str(find_spec(name).origin)).read_text()
        assert here in source
        return compile(source.replace(here, elsewhere), name, "exec")

    monkeypatch.setattr(parcels, "_code_of", as_elsewhere)


def _unsealed_region() -> tuple[int, object]:
    descriptor = parcels._unlinked()
    parcels.os.ftruncate(descriptor, container.wire.REGION_BYTES)
    return descriptor, container.wire.Region(descriptor)


@pytest.mark.usefixtures("plain_system")
def test_a_stream_socket_and_temporary_files_do() -> None:
    source = b"import sys\ndef f(x):\n    return x + 1\nif __name__ == '__main__':\n    print(input())\n"
    with open_box(source, "f.py", level="limits") as box:
        assert box.inspect().defines("f")
        assert [reply.answer for reply in box.call("f", [[1], [2.5]], LIMITS).replies] == [2, 3.5]
        assert box.run_program(b"in\n", LIMITS).stdout == b"in\n"


@pytest.mark.usefixtures("plain_system")
def test_without_a_clock_a_limit_is_noticed_afterwards() -> None:
    source = b"import time\nwhile time.process_time() < 0.3: pass\n"
    with open_box(source, "f.py", level="limits") as box:
        assert box.run_program(b"", Limits(0.1, 6.0, 256 << 20, 1 << 20)).stop is Stop.CPU
