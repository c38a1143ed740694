"""`judge completion`: what makes a shell complete judge's words."""

from __future__ import annotations

import sys

import click

from judge.cli.complete import SHELLS, script
from judge.cli.options import json_option, write_json
from judge.errors import ExitCode

SCHEMA = 1


@click.command("completion")
@click.argument("shell", metavar="SHELL", type=click.Choice(SHELLS))
@json_option
def command(shell: str, as_json: bool) -> ExitCode:
    """Print the script that lets a shell complete judge's words.

    SHELL is bash, zsh or fish. Commands, options, problems, the test groups of a problem and *.py files are
    completed.

    \b
    bash  add to ~/.bashrc:  eval "$(judge completion bash)"
    zsh   add to ~/.zshrc, after compinit:  eval "$(judge completion zsh)"
    fish  judge completion fish > ~/.config/fish/completions/judge.fish
    """
    from judge.cli.app import app  # which imports this module

    text = script(app, shell)
    if as_json:
        write_json({"schema": SCHEMA, "shell": shell, "script": text})
    else:
        sys.stdout.write(text)
        sys.stdout.flush()
    return ExitCode.ACCEPTED
