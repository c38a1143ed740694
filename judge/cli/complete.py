"""Names of katas and of files, for a shell that completes words; the rest is click's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from judge.cli.table import COMMANDS
from judge.errors import JudgeError

if TYPE_CHECKING:  # at run time click's older versions have no parameters there
    _ParamType = click.ParamType[Any]
    Items = list[CompletionItem[str]]
else:
    _ParamType = click.ParamType
    Items = list


def commands(incomplete: str) -> Items:
    """The commands that begin with what was typed, each with its sentence."""
    return [
        CompletionItem(name, help=entry.sentence)
        for name, entry in COMMANDS.items()
        if name.startswith(incomplete)
    ]


def offer_names(command: click.Command) -> None:
    """Let the command's parameters that name a kata or a file complete themselves."""
    for parameter in command.params:
        words = parameter.metavar or ""
        kata = "PROBLEM" in words or "KATA" in words
        if kata or words.strip("[].") == "FILE":
            parameter.type = _Named(kata, "FILE" in words or words.startswith("[["))


class _Named(_ParamType):
    name = "name"

    def __init__(self, katas: bool, files: bool) -> None:
        self._katas = katas
        self._files = files

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        from judge.problem.find import problem_folders

        try:
            folders = (
                problem_folders(ctx.params.get("folders") or ctx.params.get("problems") or ())
                if self._katas and not (param.nargs == -1 and ctx.params.get(param.name or ""))
                else ()
            )
            names = sorted({folder.name for folder in folders if folder.name.startswith(incomplete)})
        except (JudgeError, OSError):  # a folder that is gone: nothing to offer
            names = []
        found = [CompletionItem(name) for name in names]
        return [*found, CompletionItem(incomplete, type="file")] if self._files else found
