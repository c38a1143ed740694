"""JavaScript: the source is run as a script, and its function called; shapes are looked at as it runs."""

from __future__ import annotations

import json
import re
from typing import Any

from judge.languages.scan import changed, usual_tokens
from judge.languages.shapes import Shape
from judge.languages.spec import Spec as Draft
from judge.languages.spec import listed

_NAMES = r"(?>(?:\*\s*+as\s++)?)([\w$]++|\{[^{}]{0,1500}+\})"
_FROM = rf"(?>(?:(?>(?:([\w$]++)\s*+,\s*+)?){_NAMES}\s*+from\s*+)?)"
_IMPORT = rf"""^(?:\xef\xbb\xbf)?[ \t]*+import\s*+{_FROM}("[^"\n]*+"|'[^'\n]*+')"""


def declared(draft: Draft) -> str:
    """The function's head."""
    return f"function {draft.entry}({listed(name for name, _ in draft.parameters)})"


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    told = (f"// {shape.name} is an object {{ {listed(shape.fields)} }}" for shape in draft.structs)
    return "\n".join(told), f" {{\n  throw new Error('{words}');\n}}"


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    shapes = json.dumps([[_plain(shape) for _, shape in draft.parameters], _plain(draft.answer)])
    text = _TEMPLATE.replace("@shapes@", shapes).replace("@file@", draft.file)
    return "judge_driver.js", text.replace("@entry@", draft.entry)


def adapted(source: bytes) -> bytes:
    """The source as a script, which imports nothing, but requires it."""
    return changed(source, _IMPORT, _required, usual_tokens("//"))


def _required(found: re.Match[str]) -> str:
    """An import's names as those of constants, on as many lines."""
    of = f"require({found[3]})"
    names = (re.sub(r"(?<![\w$])([\w$]++)\s++as\s", r"\1: ", each) for each in (found[1], found[2]) if each)
    constants = ", ".join(f"{name} = {of}" for name in names)
    made = f"const {constants};" if constants else f"{of};"
    return made + "\n" * (found[0].count("\n") - made.count("\n"))


def _plain(shape: Shape) -> Any:
    return {"kind": shape.kind, "fields": shape.fields, "parts": [_plain(part) for part in shape.parts]}


_TEMPLATE = r"""'use strict';
const fs = require('fs'), vm = require('vm');
const lines = fs.readFileSync(0, 'latin1').split('\n');  // before the source reads them away
globalThis.require = require;
globalThis.module = { exports: {} };
globalThis.exports = globalThis.module.exports;
process.stdout.write = process.stderr.write.bind(process.stderr);
vm.runInThisContext(fs.readFileSync(__dirname + '/@file@', 'utf8'), { filename: '@file@' });
const entry = vm.runInThisContext('@entry@');
const [parameters, answer] = @shapes@;
function read(shape, words) {
  if (shape.kind === 'tuple') return Object.fromEntries(shape.parts.map((part, i) => [shape.fields[i], read(part, words)]));
  if (shape.kind === 'list') return Array.from({ length: +words.shift() }, () => read(shape.parts[0], words));
  if (shape.kind === 'optional') return words[0] === 'none' ? (words.shift(), null) : read(shape.parts[0], words);
  const word = words.shift();
  return shape.kind === 'word' ? word : shape.kind === 'big' ? BigInt(word) : +word;
}
const odd = (type, text) => JSON.stringify({ type, text: String(text).slice(0, 80) });
function put(value, shape) {
  if (value === null || value === undefined) return 'null';
  if (typeof value === 'bigint') return value.toString();
  if (typeof value === 'number') return Number.isFinite(value) ? String(value) : odd('float', String(value).toLowerCase());
  if (typeof value === 'string') return JSON.stringify(value);
  if (shape && shape.kind === 'optional') return put(value, shape.parts[0]);
  if (Array.isArray(value)) return '[' + value.map((item, i) => put(item, shape && (shape.kind === 'list' ? shape.parts[0] : shape.parts[i]))).join(',') + ']';
  if (typeof value === 'object' && shape && shape.kind === 'tuple' && shape.fields.every(field => field in value)) return '[' + shape.fields.map((field, i) => put(value[field], shape.parts[i])).join(',') + ']';
  return odd(typeof value === 'boolean' ? 'bool' : typeof value, value);
}
for (let at = 0; at < lines.length && lines[at] !== '';) {
  const [cases, atOnce] = lines[at++].split(' ').map(Number);
  let out = '';
  for (let left = cases; left > 0; left--) {
    try {
      const words = lines[at++].split(' ');
      out += '[0,' + put(entry(...parameters.map(shape => read(shape, words))), answer) + ']\n';
    } catch (fault) {
      out += '[1,' + JSON.stringify(String(fault)) + ']\n';
    }
    if (atOnce || left === 1) for (let bytes = Buffer.from(out); (out = '', bytes.length); ) bytes = bytes.subarray(fs.writeSync(1, bytes));
  }
}
process.exit(0);
"""
