"""Where a submission's own answers turn: its thresholds, measured by asking about wider and wider gaps.

Most of the gaps lie where no case may lie, and what is answered there judges nothing. All figures of all
borders are asked side by side, in two series of calls: one gap in each decade, then eight within the decade
in which the answer turned. A figure is left out if its answer turns more than once, changes when it is asked
for again, fails, or is neither of the two right ones. A border that loses many figures, or whose thresholds
follow no clear law, has none.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import zip_longest
from math import ceil, floor, log10

from judge.mistakes.epsilons import epsilon_mistake
from judge.mistakes.laws import NOISE, law_of
from judge.problem import Problem
from judge.problem.border import Border, Outline, Probe
from judge.run.runner import Runner
from judge.run.thresholds import Flip, Threshold
from judge.sandbox.boundary import Box, Limits, Stop

# The gaps of a decade are its power of ten times these, at equal ratios; powers of ten are halfway between.
STEPS = (1.136, 1.468, 1.896, 2.448, 3.162, 4.084, 5.275, 6.813, 8.799)
DECADES = range(-16, -1)
_BELOW = 0.3  # decades by which a gap may be rounded down from its place among them
_AROUND = 1  # decades outside of band and promise in which an accepted submission is asked

_MOST_UNCLEAR = 3  # figures of a border's nine
_CPU_SECONDS = 0.2  # of a series
_WAITING_SECONDS = 0.2


def measured(
    borders: Sequence[Border], runner: Runner, box: Box, *, first_only: bool = False
) -> tuple[Threshold, ...]:
    """The thresholds of the submission in `box`, of those borders in which they follow a clear law.

    `first_only` asks about one border only, and about gaps near the band and the promise: enough for a
    submission that is accepted. Raises what the box does.
    """
    chosen = borders[:1] if first_only else borders
    searches = [
        [_Search(probe, _decades(border, first_only), bool(border.mistaken)) for probe in border.probes]
        for border in chosen
    ]
    every = [search for figure in zip_longest(*searches) for search in figure if search is not None]
    if not _ask([(search, search.coarse()) for search in every], runner, box):
        return ()
    # Backwards: whatever is kept from figure to figure is another thing then.
    if not _ask([(search, search.fine()) for search in reversed(every)], runner, box):
        return ()
    found = [
        _threshold(border, searched, near=first_only)
        for border, searched in zip(chosen, searches, strict=True)
    ]
    return tuple(each for each in found if each is not None)


def _decades(border: Border, near: bool) -> range:
    """The powers of ten of the gaps to begin with, as shares of a figure's size."""
    if not near or not border.within:
        return DECADES
    return range(floor(log10(border.within)) - _AROUND, ceil(log10(border.beyond)) + _AROUND)


class _Search:
    """What the submission has said in one figure, by true gap: True for none, False for one."""

    def __init__(self, probe: Probe, decades: range, mistaken: bool) -> None:
        self.probe = probe
        self._mistaken = mistaken
        self.unclear = False  # it has failed, or said something else
        self._decades = decades
        self._said: dict[float, bool] = {}

    def coarse(self) -> list[float]:
        """The least gap, usually 0, and one in each decade."""
        least = self.probe.least * self.probe.size
        return [least, *self._within(STEPS[0] * 10.0**decade for decade in self._decades)]

    def fine(self) -> list[float]:
        """The decade in which the answer turned, from its wide end back to the other one.

        Both ends are asked again, and in the other order: what is kept between calls answers otherwise then.
        """
        low, high = self.turn
        if self.unclear or high is None:
            return []
        if not low:
            return [high, self.probe.least * self.probe.size]
        decade = floor(log10(low / self.probe.size / STEPS[0]) + _BELOW)
        return [high, *reversed(self._within(step * 10.0**decade for step in STEPS[1:])), low]

    def _within(self, shares: Iterable[float]) -> list[float]:
        probe = self.probe
        return [share * probe.size for share in shares if probe.least < share <= probe.widest]

    def hear(self, gap: float, outline: Outline) -> None:
        """What was answered at a true gap."""
        form = self.probe.form(outline, gap)
        none = form == self.probe.near
        if form not in (self.probe.near, self.probe.far) or self._said.get(gap, none) is not none:
            self.unclear = True
        self._said[gap] = none

    @property
    def touched(self) -> bool:
        """Whether the gap 0 was taken for none; where only a mistake takes it so, whether any gap was."""
        return any(self._said.values()) if self._mistaken else self._said.get(0.0, False)

    @property
    def turn(self) -> tuple[float, float | None]:
        """The greatest gap that was taken for none, and the least one beyond it that was not."""
        low = max((gap for gap, none in self._said.items() if none), default=0.0)
        return low, min((gap for gap, none in self._said.items() if not none and gap > low), default=None)

    def flip(self) -> Flip | None:
        """Where the answer turned, None where it turned more than once: below the noise it may, and below
        a mistake's own threshold."""
        low, high = self.turn
        noise = low if self._mistaken else NOISE * self.probe.size
        if self.unclear or any(noise < gap < low for gap, none in self._said.items() if not none):
            return None
        return Flip(self.probe.sizes, low, high)


def _ask(asked: Sequence[tuple[_Search, list[float]]], runner: Runner, box: Box) -> bool:
    """Ask about all these gaps in one series; whether it came to its end."""
    cases, heard = [], []
    for search, gaps in asked:
        for gap in gaps:
            case, true = search.probe.at(gap)
            cases.append(case)
            heard.append((search, true))
    if not cases:
        return True
    replies = runner.answers(box, cases, _limits(runner.problem))
    if replies.breakdown is not None or len(replies.replies) != len(cases):
        return False
    outlines: dict[str, Outline] = {}  # most answers come again and again, and an outline takes its time
    for (search, true), reply in zip(heard, replies.replies, strict=True):
        if reply.stop is Stop.ANSWERED:
            key = repr(reply.answer)
            if key not in outlines:
                outlines[key] = runner.outline(reply.answer)
            search.hear(true, outlines[key])
        elif reply.stop is Stop.EXCEPTION:
            search.unclear = True
        else:
            return False
    return True


def _limits(problem: Problem) -> Limits:
    usual = problem.limits
    return Limits(
        min(_CPU_SECONDS, usual.cpu_seconds),
        min(_CPU_SECONDS + _WAITING_SECONDS, usual.wall_seconds),
        usual.memory_bytes,
        usual.output_bytes,
        waiting_seconds=_WAITING_SECONDS,
        items=problem.answer.items,
    )


def _threshold(border: Border, searches: Sequence[_Search], *, near: bool) -> Threshold | None:
    """The border's thresholds, if most figures have one and they follow a law."""
    flips = [flip for search in searches if (flip := search.flip()) is not None]
    # Where only a mistake takes a gap for none, few figures may be small or large enough to show it.
    touched = sum(each.touched for each in searches)
    least = 1 if border.mistaken else len(searches) / 2
    if len(flips) < len(searches) - _MOST_UNCLEAR or touched < least:
        return None
    if near and not all(flip.low and flip.high for flip in flips):
        return None  # it turns where nothing was asked
    law = law_of(flips)
    if law is None:
        return None
    size = next(iter(flips[0].sizes))
    mistake = epsilon_mistake(law, size, border.within, border.beyond)
    return Threshold(border.about, border.within, border.beyond, tuple(flips), law, mistake)
