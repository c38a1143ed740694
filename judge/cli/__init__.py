"""The command line: thin, and quick to start.

    app.py          the commands' table, loading a command when it is used, and how everything ends
    options.py      options and look-ups that several commands share
    submissions.py  reading the files to judge
    run.py, list.py, show.py, data.py, verify.py   one command each, named `command`

Starting is kept short on purpose: `judge --help` imports click and nothing else of weight.
"""

from __future__ import annotations

import gc
import sys
from typing import NoReturn

_INTERRUPTED = 130  # ExitCode.INTERRUPTED, which may not be imported yet


def main() -> NoReturn:
    """The console script."""
    try:
        gc.disable()  # imports make no garbage, and looking for it takes a twentieth of the start
        from judge.cli.app import app  # in here, so that an early Ctrl-C is as quiet as a late one

        gc.enable()
        app.main()
    except KeyboardInterrupt:
        sys.exit(_INTERRUPTED)
