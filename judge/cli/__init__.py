"""The command line: thin, and quick to start.

    table.py        the commands: sentence, module, page of the manual, examples; old names
    app.py          loading a command when it is used, completing words, and how everything ends
    options.py      options as fields of structs; a command's value to JSON, or to its view in judge/report
    commands/       the commands
    resolve.py      what words mean; the history, and the current kata of a folder
    files.py        the files to judge, and those that options write
    judging.py      what run and start ask of `judge.judging`, each result kept; a file under watch
    aid.py          hints, and the model solution
    home.py         `judge` alone: where a person stands, and the next kata
    watch_screen.py the loop of `judge start`

Starting is kept short on purpose: `judge --help` imports click and nothing else of weight.
"""

from __future__ import annotations

import _signal as signal  # type: ignore[import-not-found]  # signal itself takes longer to import
import atexit
import gc
import os
import sys

TYPE_CHECKING = False  # typing's is slow to import, and nothing may be slow before Ctrl-C is seen to
if TYPE_CHECKING:
    from types import FrameType
    from typing import NoReturn

_INTERRUPTED = 130  # ExitCode.INTERRUPTED, which may not be imported yet
_OFTEN_ENOUGH = 100_000  # new objects until garbage is looked for, which a run hardly makes


def main() -> NoReturn:
    """The console script."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:  # not for who runs us to ignore it
        signal.signal(signal.SIGINT, _leave)
    _open_standard_streams()
    alone = sys._getframe(1).f_back is None  # the console script, but no profiler or test
    if alone:
        gc.set_threshold(_OFTEN_ENOUGH)
    try:
        from judge.cli.app import app  # in here, so that an early Ctrl-C is as quiet as a late one

        app.main()
    except KeyboardInterrupt:
        sys.exit(_INTERRUPTED)
    except SystemExit as left:
        status = left.code  # and its frames are let go, with all that they held open
    finally:
        # Of an interrupt inside an exec of text, as namedtuple does one, Python keeps a mark though it was
        # handled, and in place of our status it would end by SIGINT. The next exec takes the mark away.
        exec("")
    if alone and status in (0, 1):
        _end(status)
    sys.exit(status)


def imported() -> None:
    """All that takes long is imported: from here on Ctrl-C is an exception, and things are cleared up."""
    if signal.getsignal(signal.SIGINT) is _leave:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def _leave(_number: int, _frame: FrameType | None) -> NoReturn:
    """Ctrl-C while modules are imported, where an exception is now and then lost in the locks of imports."""
    os._exit(_INTERRUPTED)  # nothing has been started or written


def _end(status: int) -> None:
    """End the process as the interpreter does, but leave its modules standing: to take them down is a tenth
    of an accepted run. Where the output cannot be written, the interpreter is to say so.
    """
    try:
        if threading := sys.modules.get("threading"):
            threading._shutdown()
        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, ValueError, KeyboardInterrupt):
        return
    os._exit(status)


def _open_standard_streams() -> None:
    """Give a closed standard stream (`<&-`, some daemons) the null device.

    Otherwise the next file takes its number: a contained process would have its channel replaced by its own
    standard input, and an accepted submission would be called a forger. Standard output is opened for
    reading only, so that what is written there still fails: nobody got the result.
    """
    for number, (name, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
        try:
            os.fstat(number)
        except OSError:
            # The least number that is free: this one.
            os.open(os.devnull, os.O_RDONLY if name == "stdout" else os.O_RDWR)
        if getattr(sys, name) is None:
            stream = open(number, mode, encoding="utf-8", closefd=False)  # noqa: SIM115 - as long as we run
            setattr(sys, name, stream)
