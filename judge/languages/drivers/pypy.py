"""PyPy: the source is a module, whose function is called; a tuple is a tuple."""

from __future__ import annotations

from judge.languages.shapes import Shape
from judge.languages.spec import Spec as Draft
from judge.languages.spec import listed


def declared(draft: Draft) -> str:
    """The function's head."""
    return f"def {draft.entry}({listed(name for name, _ in draft.parameters)}):"


def frame(_draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    return "", f'\n    raise NotImplementedError("{words}")'


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    reads = listed(_read(shape) for _, shape in draft.parameters)
    text = _TEMPLATE.replace("@reads@", reads).replace("@file@", draft.file)
    return "judge_driver.pypy", text.replace("@entry@", draft.entry)


def _read(shape: Shape) -> str:
    """The expression that takes a value from the words."""
    if shape.kind == "tuple":
        return f"({listed(map(_read, shape.parts))},)"
    if shape.kind == "list":
        return f"[{_read(shape.inner)} for _ in range(int(take()))]"
    if shape.kind == "optional":
        return f'(None if words[-1] == "none" and take() else {_read(shape.inner)})'
    return "take()" if shape.kind == "word" else "number(take())"


_TEMPLATE = r"""import json, os, sys
answers = os.dup(1)
os.dup2(2, 1)
lines = iter(sys.stdin.read().split("\n"))  # before the source reads them away
path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "@file@")
module = {"__name__": "solution", "__file__": "@file@"}
exec(compile(open(path, "rb").read(), "@file@", "exec"), module)
entry = module["@entry@"]
def number(word):
    return float(word) if "." in word or "e" in word or "n" in word else int(word)
def plain(value):
    if isinstance(value, bool):
        return {"type": "bool", "text": str(value)}
    if isinstance(value, float) and value - value != 0.0:
        return {"type": "float", "text": repr(value)}
    if value is None or isinstance(value, (int, float, str)):
        return value
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return {"type": type(value).__name__, "text": repr(value)[:80]}
def written(value):
    kind = type(value)
    if kind is float and value - value == 0.0:
        return repr(value)
    if kind is int:
        return str(value)
    if kind is tuple or kind is list:
        return "[" + ",".join([written(item) for item in value]) + "]"
    return json.dumps(plain(value))
def answer(line):
    words = line.split()
    words.reverse()
    take = words.pop
    try:
        return "[0," + written(entry(@reads@)) + "]\n"
    except MemoryError:
        raise
    except BaseException as fault:
        return json.dumps([1, "%s: %s" % (type(fault).__name__, fault)]) + "\n"
def drive(lines):
    for head in lines:
        if not head:
            return
        cases, at_once = map(int, head.split())
        out = []
        for left in range(cases - 1, -1, -1):
            out.append(answer(next(lines)))
            if at_once or not left:
                data = "".join(out).encode()
                while data:
                    data = data[os.write(answers, data):]
                out = []
drive(lines)
os._exit(0)
"""
