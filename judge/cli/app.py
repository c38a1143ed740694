"""The `judge` command: its table of commands, and the one place where faults become a line and a status."""

from __future__ import annotations

import errno
import importlib
import os
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING, Any, NoReturn

import click

from judge import __version__
from judge.cli import imported
from judge.cli.table import COMMANDS, HEADINGS, LIKE
from judge.errors import ExitCode, JudgeError, UsageError, nearest, shortage

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

_DEBUG = "--debug"
_COMPLETING = "_JUDGE_COMPLETE"  # a variable of click's
_NARROWEST, _USUAL_WIDTH, _WIDEST = 30, 80, 100  # columns of help
_UNWRITABLE = (errno.ENOSPC, errno.EDQUOT, errno.EBADF)  # no fault of ours: a full disk, a closed stream
_BETTER = (  # than what click says
    ("a valid integer( range)?", "a whole number"),
    (r"in the range (\d+)<=x<=(\d+)", r"from \1 to \2"),
    (r"in the range x>=(\d+)", r"\1 or more"),
    (".*'--format': 'json'.*", "--json writes JSON"),
)
_CLOSED_PIPE = 141  # what a shell reports of any filter whose reader has left: 128 + SIGPIPE


class Commands(click.Group):
    """A group that imports a command's module when the command is used, and says every fault in one line."""

    def get_command(self, ctx: click.Context | None, cmd_name: str) -> click.Command | None:
        """The command of that name, its module imported now."""
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f"judge.cli.commands.{COMMANDS[cmd_name].module}")
        commands = [each for each in vars(module).values() if isinstance(each, click.Command)]
        command = next(each for each in commands if each.name == cmd_name)
        imported()
        examples = "\n".join(f"  {each}" for each in COMMANDS[cmd_name].examples)
        more = f"More: judge help {COMMANDS[cmd_name].topic}; --json writes JSON"
        command.epilog = f"\b\nFor example:\n{examples}\n\n{more}"
        if ctx is not None and ctx.resilient_parsing:  # a shell asks
            for each in command.params:
                if re.search("KATA|FILE", each.metavar or ""):
                    each.shell_complete = partial(_offered, each)  # type: ignore[method-assign]
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command that the first argument names; any other name is refused with a near one."""
        name = args[0]
        if not ctx.resilient_parsing and name not in COMMANDS and not name.startswith("-"):
            raise UsageError(_unknown(name))
        return super().resolve_command(ctx, args)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem[str]]:
        """What a shell may offer for the first word: from the table, without importing any command."""
        from click.shell_completion import CompletionItem

        fitting = [(name, entry) for name, entry in COMMANDS.items() if name.startswith(incomplete)]
        mine = [CompletionItem(name, help=entry.sentence) for name, entry in fitting]
        return [*mine, *click.Command.shell_complete(self, ctx, incomplete)]

    def format_help(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The commands by what a person wants to do, the further ones by name, the options on a line.

        All within a screen of 24 lines, and without importing any.
        """
        formatter.write(f"{self.help} Usage: judge COMMAND ...\n")
        *listed, named = HEADINGS
        for heading in listed:
            with formatter.section(heading):
                formatter.write_dl([(name, entry.sentence) for name, entry in HEADINGS[heading].items()])
        names = [name for each in self.get_params(ctx) for name in each.opts if name[:2] == "--"]
        formatter.write(f"{named}: {', '.join(HEADINGS[named])}\nOptions: {', '.join(names)}\n")

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; click would end with 1 where who read standard output has left, as `head` does."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            from judge.report.screen import hush

            hush(sys.stdout)
            sys.exit(_CLOSED_PIPE)

    def main(  # type: ignore[override]
        self, args: Sequence[str] | None = None, prog_name: str | None = None, **settings: Any
    ) -> NoReturn:
        """Run the command line and leave with its status; nothing but `--debug` shows a traceback."""
        words = list(sys.argv[1:] if args is None else args)
        end = words.index("--") if "--" in words else len(words)  # what stands behind it is not ours
        kept = [word for word in words[:end] if word != _DEBUG] + words[end:]
        settings["standalone_mode"] = False
        settings.setdefault("terminal_width", _help_width())
        with suppress(AttributeError):  # it is closed; of other streams than a file nothing is to be feared
            sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
        try:
            status = super().main(kept, prog_name or "judge", **settings)
        except (click.Abort, KeyboardInterrupt):
            sys.exit(ExitCode.INTERRUPTED)
        except Exception as fault:
            from judge.report.screen import hush, note  # only for the one who is told

            if kept != words and not isinstance(fault, UsageError | click.UsageError):
                import traceback

                with suppress(OSError):  # standard error is full
                    traceback.print_exception(fault)
            message, status = explain(fault)
            note(message, bad=True)
            if isinstance(fault, OSError):
                hush(sys.stdout)
        sys.exit(int(status or 0))


def _offered(parameter: click.Parameter, ctx: click.Context, incomplete: str) -> list[CompletionItem[str]]:
    """The katas and files that a shell may offer for a parameter that names them."""
    from click.shell_completion import CompletionItem

    from judge.problem.find import problem_folders

    words, found = parameter.metavar or "", []
    if "KATA" in words and not (parameter.nargs == -1 and ctx.params.get(parameter.name or "")):
        with suppress(JudgeError, OSError):  # a folder that is gone: nothing to offer
            names = sorted({folder.name for folder in problem_folders(ctx.params.get("problems") or ())})
            found = [CompletionItem(name) for name in names if name.startswith(incomplete)]
    return [*found, CompletionItem(incomplete, type="file")] if "FILE" in words else found


def _unknown(name: str) -> str:
    """That there is no such command, and what was most likely meant."""
    if os.path.isfile(name):  # noqa: PTH113 - of any name
        from judge.report.words import shown_command  # only for the one who is told

        return f"There is no command {name}. To judge that file: {shown_command('judge', 'run', file=name)}"
    near = LIKE.get(name) or nearest(name, COMMANDS)
    meant = f"Did you mean judge {near}?" if near else "judge --help shows the commands"
    return f"There is no command {name if name.isprintable() else ascii(name)}. {meant}"


def explain(fault: Exception) -> tuple[str, int]:
    """The line and the exit status that `fault` comes to."""
    if isinstance(fault, JudgeError):
        return str(fault), fault.exit_code
    if isinstance(fault, click.MissingParameter) and fault.param and "KATA" in (fault.param.metavar or ""):
        return "Which kata? judge list shows them", ExitCode.USAGE
    if isinstance(fault, click.UsageError):
        message = _usage(fault)
        if fault.ctx and not message.endswith("?"):
            message += f"; see '{fault.ctx.command_path} --help'"
        return message, ExitCode.USAGE
    if isinstance(fault, OSError) and fault.errno in _UNWRITABLE:
        return f"cannot write ({os.strerror(fault.errno).lower()})", ExitCode.FAULT
    if isinstance(fault, OSError) and fault.errno == errno.ENAMETOOLONG:
        return f"no file can have a name as long as {str(fault.filename)[:40]!r}…", ExitCode.USAGE
    if _COMPLETING in os.environ and isinstance(fault, LookupError | ValueError):
        return f"only a shell that completes a word sets {_COMPLETING}; unset it", ExitCode.USAGE
    short = None if isinstance(fault, BlockingIOError) else shortage(fault)  # that may be a pipe's
    if short:
        return str(short), short.exit_code
    what = ": ".join(filter(None, (type(fault).__name__, " ".join(str(fault).split()))))
    return f"internal fault: {what}; run again with {_DEBUG} for the traceback", ExitCode.FAULT


def _usage(fault: click.UsageError) -> str:
    """click's message, in the form of the judge's own: no capital, no full stop, the nearest option named."""
    if not isinstance(fault, click.NoSuchOption):
        message = " ".join(fault.format_message().split()).rstrip(".")
        for said, better in _BETTER:
            message = re.sub(said, better, message)
        return message[:1].lower() + message[1:]
    said = f"no such option '{fault.option_name}'"
    own = fault.ctx.command.get_params(fault.ctx) if fault.ctx else ()
    meant = nearest(fault.option_name, [word for each in own for word in each.opts if word[:1] == "-"])
    if fault.option_name == "--level":
        meant = " ".join(["judge", *sys.argv[1:]]).replace("--level=", "").replace("--level ", "")
    return f"{said}; did you mean '{meant}'?" if meant else said


def _help_width() -> int:
    """The columns for help: those of the terminal, in bounds. click would import a good deal to find them."""
    found = os.environ.get("COLUMNS", "")
    with suppress(OSError, ValueError, AttributeError):  # into a pipe, a closed stream
        found = found or str(os.get_terminal_size(sys.__stdout__.fileno()).columns)  # type: ignore[union-attr]
    columns = int(found) if found.isdecimal() else 0
    return max(min(columns or _USUAL_WIDTH, _WIDEST) - 2, _NARROWEST)


@click.group(
    cls=Commands, invoke_without_command=True, context_settings={"help_option_names": ["-h", "--help"]}
)
@click.version_option(__version__, "-V", "--version", message="judge %(version)s")
@click.option(_DEBUG, is_flag=True, expose_value=False, help="Show the traceback of a fault.")
@click.pass_context
def app(ctx: click.Context) -> None:
    """Practise katas, offline."""
    if ctx.invoked_subcommand is None:
        from judge.cli.home import home
        from judge.cli.options import Common, emit

        imported()
        emit(home(Common()), Common())
