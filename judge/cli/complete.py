"""What a shell offers when TAB is pressed, by click's own mechanism.

The script that `judge completion SHELL` prints runs judge with `_JUDGE_COMPLETE=<shell>_complete` and the
words of the line so far; what is answered are lines of a kind and a value. click knows the commands and the
options; the table below says what an argument may become, by its name in the help. To click's kinds `plain`,
`file` and `dir` comes `py`: then the shell completes *.py files and folders itself.

Whatever goes wrong is silent: a message would end up in the middle of what is being typed.
"""

from __future__ import annotations

import copy
import os
import sys
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import (
    BashComplete,
    CompletionItem,
    FishComplete,
    ShellComplete,
    ZshComplete,
    split_arg_string,
)

from judge.errors import JudgeError
from judge.languages import PATTERN, SUFFIX

if TYPE_CHECKING:  # at run time click's older versions have no parameters there
    _ParamType = click.ParamType[Any]
    Items = list[CompletionItem[str]]
else:
    _ParamType = click.ParamType
    Items = list

VARIABLE = "_JUDGE_COMPLETE"
Offer = Callable[[click.Context, click.Parameter, str], Items]


def answer(app: click.Group, instruction: str) -> int:
    """Write what the shell asks for, `bash_complete` say; the exit status."""
    shell, _, what = instruction.partition("_")
    try:
        text = script(app, shell) if what == "source" else _in(shell, app).complete()
        sys.stdout.write(f"{text}\n")
        sys.stdout.flush()
    except Exception:
        return 1
    return 0


def script(app: click.Group, shell: str) -> str:
    """What a shell reads so that it asks judge. Raises KeyError for an unknown one."""
    return ShellComplete.source(_in(shell, app))  # past click's search for a bash to ask its version


def among(choices: Iterable[tuple[str, str]], incomplete: str) -> Items:
    """The choices, each with its explanation, that begin with what was typed."""
    return [CompletionItem(name, help=text) for name, text in choices if name.startswith(incomplete)]


def offering(command: click.Command) -> click.Command:
    """The command with parameters that know what a shell may offer for them."""
    command = copy.copy(command)
    command.params = [_offering(parameter) for parameter in command.params]
    return command


def _offering(parameter: click.Parameter) -> click.Parameter:
    offer = _OFFERS.get((parameter.param_type_name, _name(parameter)))
    if (parameter.metavar or "").startswith(_OR_A_FILE):
        offer = _problems_and_files
    if offer is None:
        return parameter
    parameter = copy.copy(parameter)
    parameter.type = _Offered(parameter.type, offer)
    return parameter


def _name(parameter: click.Parameter) -> str:
    """What the help calls it: PROBLEM of `[PROBLEM]...`, `PROBLEM|FILE`; of several words the first."""
    return (parameter.metavar or "").strip("[].").partition("|")[0].partition("] [")[0]


class _Offered(_ParamType):
    """A type of values, and what to offer for one."""

    def __init__(self, kind: _ParamType, offer: Offer) -> None:
        self.name = kind.name
        self._kind = kind
        self._offer = offer

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return self._kind.convert(value, param, ctx)

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> Items:
        try:
            return self._offer(ctx, param, incomplete)
        except (JudgeError, OSError):  # a broken problem, a folder that is gone: nothing to offer
            return []


# -- what there is to offer ------------------------------------------------------------------------------


def _problems(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> Items:
    """Ids of problems; installed packs are searched, which takes longer, only where no other one fits."""
    from judge.problem.find import near_problem_folders, problem_folders

    extra = ctx.params.get("folders") or ()
    given = ctx.params.get(parameter.name or "")
    taken = given if isinstance(given, tuple) else ()
    for folders in (near_problem_folders, problem_folders):
        names = sorted({folder.name for folder in folders(extra)} - set(taken))
        found = among([(name, "") for name in names], incomplete)
        if found:
            return found
    return []


def _problems_and_files(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> Items:
    """Where a file tells its problem: either."""
    return [*_problems(ctx, parameter, incomplete), CompletionItem(incomplete, type=_KIND)]


def _groups(ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    """The test groups of the problem that was typed before."""
    from judge.cli.fitting import problem_meant

    typed = [ctx.params.get(each.name or "") for each in ctx.command.params if _name(each) == "PROBLEM"]
    # Behind an option that still lacks its value click has not looked: there the words are as they came.
    names = [name for name in (*typed, *ctx.args) if isinstance(name, str)]
    if not names:
        return []
    problem = problem_meant(names[0], "run", ctx.params.get("folders") or (), ctx.params.get("db"))
    return among([(group.name, group.about) for group in problem.groups], incomplete)


def _mistakes(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> Items:
    """The numbers of the problem's wrong programs; of those that were named already, the names too."""
    from judge.kata.hacks import HackState, hack_states
    from judge.kata.history import History
    from judge.mistakes.puzzles import read_puzzles
    from judge.problem.find import find_problem

    if ctx.params.get(parameter.name or ""):
        return []  # a case may be anything
    puzzles = read_puzzles(find_problem(ctx.params["name"], ctx.params.get("folders") or ()))
    with History.open(ctx.params.get("db"), reading=True) as history:
        hacks = history.hacks(ctx.params["name"])
    states = hack_states([puzzle.mistake for puzzle in puzzles], hacks)
    known = [puzzle for puzzle in puzzles if states[puzzle.mistake] is not HackState.OPEN]
    numbers = [(str(puzzle.number), states[puzzle.mistake].value) for puzzle in puzzles]
    return among([*numbers, *((puzzle.mistake, "") for puzzle in known)], incomplete)


def _sets(ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    from judge.kata.sets import set_names

    return among([(name, "") for name in set_names(ctx.params.get("folders") or ())], incomplete)


def _schemas(_ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    from judge.schema import commands, files

    return among([(name, "") for name in sorted([*commands(), *files()])], incomplete)


def _forms(_ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    from judge.kata.quiz.forms import NAMES

    return among([(name, "") for name in NAMES], incomplete)


def _rows(ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    from judge.kata.checklist import read_checklist

    rows = read_checklist(ctx.params.get("folders") or ()).rows
    return among([(row.id, row.ask) for row in rows], incomplete.upper())


def _cards(ctx: click.Context, _parameter: click.Parameter, incomplete: str) -> Items:
    from judge.kata.quiz.cards import sound_decks

    decks, _ = sound_decks(ctx.params.get("folders") or ())
    return among([(card.key, card.front) for deck in decks for card in deck.cards], incomplete)


def _kind(kind: str) -> Offer:
    """Leave it to the shell, which knows its own quotes and tildes."""
    return lambda _ctx, _parameter, incomplete: [CompletionItem(incomplete, type=kind)]


_OR_A_FILE = ("[[PROBLEM]", "PROBLEM|FILE", "[PROBLEM|FILE")  # what may be a file as well
_KIND = SUFFIX.removeprefix(".")  # of what is to be completed: a program's file
_OFFERS: dict[tuple[str, str], Offer] = {
    ("argument", "PROBLEM"): _problems,
    ("argument", "GROUP"): _groups,
    ("argument", "SET"): _sets,
    ("argument", "MISTAKE"): _mistakes,
    ("argument", "COMMAND"): _schemas,
    ("argument", "FILE"): _kind(_KIND),
    ("argument", "DIR"): _kind("dir"),
    ("option", "G"): _groups,
    ("option", "DIR"): _kind("dir"),
    ("option", "PROBLEM"): _problems,
    ("option", "ROW"): _rows,
    ("option", "FORM"): _forms,
    ("option", "CARD"): _cards,
}


# -- the shells ------------------------------------------------------------------------------------------


class _Files(ShellComplete):
    """A script that leaves the completion of programs' files to the shell."""

    def source_vars(self) -> Any:
        return {**super().source_vars(), "kind": _KIND, "pattern": PATTERN, "suffix": SUFFIX}


class _Bash(_Files, BashComplete):
    """bash takes `--group=x` for three words, and a word may be empty: they come a line each."""

    source_template = """\
%(complete_func)s() {
    local IFS=$'\\n' kind value name response
    response=$(env COMP_WORDS="${COMP_WORDS[*]:0:COMP_CWORD+1}" COMP_CWORD="$COMP_CWORD" \\
        %(complete_var)s=bash_complete "$1" 2>/dev/null)
    while IFS=',' read -r kind value; do
        case $kind in
            dir) compopt -o dirnames 2>/dev/null ;;
            file) compopt -o default 2>/dev/null ;;
            %(kind)s)
                compopt -o filenames -o plusdirs 2>/dev/null
                while read -r name; do
                    COMPREPLY+=("$name")
                done < <(compgen -f -X '!%(pattern)s' -- "$2") ;;
            plain) COMPREPLY+=("$value") ;;
        esac
    done <<< "$response"
}
complete -o nosort -F %(complete_func)s %(prog_name)s 2>/dev/null ||
    complete -F %(complete_func)s %(prog_name)s
"""

    def get_completion_args(self) -> tuple[list[str], str]:
        words = [_plain(word) for word in os.environ["COMP_WORDS"].split("\n")]
        *args, incomplete = words[1:] or [""]
        kept = [
            word for index, word in enumerate(args) if not (word == "=" and args[index - 1].startswith("--"))
        ]
        return kept, incomplete


def _plain(word: str) -> str:
    """A word without the quotes and backslashes that it was typed with."""
    return "".join(split_arg_string(word))


class _Zsh(_Files, ZshComplete):
    source_template = """\
#compdef %(prog_name)s

%(complete_func)s() {
    local program=${(Q)words[1]} line="${words[*]}" place=$((CURRENT-1)) kind value about
    local -a response explained bare
    compset -P '--*='
    response=("${(@f)$(env COMP_WORDS="$line" COMP_CWORD=$place \\
        %(complete_var)s=zsh_complete $program 2>/dev/null)}")
    for kind value about in $response; do
        case $kind in
            dir) _path_files -/ ;;
            file) _files ;;
            %(kind)s) _files -g '%(pattern)s' ;;
            plain)
                if [[ $about == _ ]]; then
                    bare+=("$value")
                else
                    explained+=("$value:$about")
                fi ;;
        esac
    done
    (( $#explained )) && _describe -V unsorted explained
    (( $#bare )) && compadd -V unsorted -a bare
}

if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    %(complete_func)s "$@"
elif (( $+functions[compdef] )); then
    compdef %(complete_func)s %(prog_name)s
fi
"""


class _Fish(_Files, FishComplete):
    source_template = """\
function %(complete_func)s
    set -l response (env %(complete_var)s=fish_complete COMP_WORDS=(commandline -cp | string collect) \\
        COMP_CWORD=(commandline -t | string collect) %(prog_name)s 2>/dev/null)
    set -l option (commandline -t | string match -r -- '^--[^=]*=' | string collect --allow-empty)
    for completion in $response
        set -l metadata (string split -m 1 "," -- $completion)
        switch $metadata[1]
            case dir
                __fish_complete_directories $metadata[2]
            case file
                __fish_complete_path $metadata[2]
            case %(kind)s
                __fish_complete_path $metadata[2] | string match -r '^.*(?:/|\\%(suffix)s)(?:\\t.*)?$'
            case plain
                echo $metadata[2]
        end
    end | string replace -r '^' -- "$option"
end

complete --no-files --command %(prog_name)s --arguments "(%(complete_func)s)"
"""


_SHELLS: dict[str, type[ShellComplete]] = {"bash": _Bash, "zsh": _Zsh, "fish": _Fish}
SHELLS = tuple(_SHELLS)


def _in(shell: str, app: click.Group) -> ShellComplete:
    return _SHELLS[shell](app, {}, "judge", VARIABLE)
