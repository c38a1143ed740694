"""Which view shows a value: the name of its class, and the module that is imported only then.

A view takes the value and the screen and returns what rich can draw; it writes nothing itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Any

from judge.report.screen import Screen

if TYPE_CHECKING:
    from rich.console import RenderableType

# the name of a value's class -> the module in judge/report, and the function in it
VIEWS: Mapping[str, tuple[str, str]] = {
    "Home": ("home", "home"),
    "Begun": ("home", "begun"),
    "KataList": ("katas", "kata_list"),
    "KataShown": ("katas", "kata_shown"),
    "NewKata": ("setter", "new_kata"),
    "Verified": ("setter", "verified"),
    "DecksVerified": ("setter", "decks_verified"),
    "VerifySummary": ("setter", "verify_summary"),
    "FilesWritten": ("setter", "files_written"),
    "Exported": ("setter", "exported"),
    "Doctor": ("setter", "doctor"),
    "Judged": ("judged", "judged"),
    "Several": ("judged", "several"),
    "CaseTried": ("trying", "case_tried"),
    "PageWritten": ("trying", "page_written"),
    "HackTurn": ("hacking", "hack_turn"),
    "RunList": ("history", "run_list"),
    "RunShown": ("history", "run_shown"),
    "RunsCompared": ("history", "runs_compared"),
    "Restored": ("history", "restored"),
    "HintShown": ("solution", "hint"),
    "SolutionShown": ("solution", "solution"),
    "ProgressPage": ("learned", "progress_page"),
    "QuestionShown": ("learned", "question"),
    "DueShown": ("learned", "due"),
    "ProgressWritten": ("learned", "page_written"),
    "CardList": ("quiz", "card_list"),
    "Quizzed": ("quiz", "quizzed"),
    "Interviewed": ("quiz", "interviewed"),
    "Cohort": ("klass", "klass"),
    "HackStanding": ("hacking", "hack_standing"),
    "Topics": ("manual", "topics"),
    "PageShown": ("manual", "page"),
    "Mentions": ("manual", "mentions"),
    "Document": ("manual", "document"),
}


def view(value: object, screen: Screen) -> RenderableType:
    """What the screen shows of `value`. Raises KeyError for a class that has no view."""
    module, function = VIEWS[type(value).__name__]
    drawn: Any = getattr(import_module(f"judge.report.{module}"), function)
    shown: RenderableType = drawn(value, screen)
    return shown
