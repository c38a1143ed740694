"""The box beside a submission's own, in which its text is looked at and changed; opened when first asked."""

from __future__ import annotations

from contextlib import ExitStack
from functools import cached_property

from judge.problem.solutions import LONGEST
from judge.repair.child import NAME, SOURCE
from judge.repair.features import FEATURES, LIBRARY
from judge.sandbox.boundary import Box, BoxFactory, Limits, Stop
from judge.values.wire import word

_LIMITS = Limits(cpu_seconds=5.0, wall_seconds=15.0, memory_bytes=1 << 29, output_bytes=1 << 16)


class Beside:
    """A context manager that ends the box. `text` is the submission's, None where there is none in Python."""

    def __init__(self, boxes: BoxFactory, source: bytes, *, python: bool) -> None:
        self._boxes, self._stack = boxes, ExitStack()
        self.too_long = len(source) > LONGEST
        self.text: str | None = None
        if python and not self.too_long:
            try:
                self.text = source.decode("utf-8-sig")
            except UnicodeDecodeError:
                self.text = source.decode("latin-1")

    def __enter__(self) -> Beside:
        return self

    def __exit__(self, *exc: object) -> None:
        self._stack.close()

    @cached_property
    def box(self) -> Box:
        """Raises JudgeError where none can be opened."""
        return self._stack.enter_context(self._boxes(SOURCE, NAME))

    def features(self) -> frozenset[str] | None:
        """What its syntax tree has, as far as it says so; nothing of what is no Python. Raises JudgeError.

        None where it is longer than what anybody writes. One whose work lies in a library has no text
        any more.
        """
        if self.too_long:
            return None
        if self.text is None:
            return frozenset()
        (reply,) = self.box.call("features", [(self.text,)], _LIMITS).replies[:1]
        said = reply.answer if reply.stop is Stop.ANSWERED and isinstance(reply.answer, list) else []
        found = {*FEATURES, LIBRARY} & {word(each) for each in said}
        self.text = None if LIBRARY in found else self.text
        return frozenset(found)
