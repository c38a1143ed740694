"""A picture without the answers in it: what a question shows."""

from __future__ import annotations

from dataclasses import replace

from judge.drawing.shapes import Panel, Picture, Role

_ANSWERS = (Role.WANTED, Role.GOT)


def unanswered(picture: Picture) -> Picture:
    """The figure at true scale alone: no answer, no lens, and no words but the names of its points."""
    return replace(picture, heading="", description="", whole=_bare(picture.whole), lens=None, facts=())


def _bare(panel: Panel) -> Panel:
    strokes = tuple(stroke for stroke in panel.strokes if stroke.role not in _ANSWERS)
    marks = tuple(
        replace(mark, text=mark.text.partition(",")[0], shared=False)
        for mark in panel.marks
        if mark.role not in _ANSWERS
    )
    return replace(panel, title="", strokes=strokes, marks=marks, note="")
