"""Rust: the source is included, and the driver is a module below it, which sees what is private.

An integer of any size is given as its decimal digits in a String, or as an i64 or i128 where the function is
declared so.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from judge.languages.shapes import Shape, Unsupported, atom
from judge.languages.spec import Spec as Draft
from judge.languages.spec import joined, listed, small

_ATOMS = {"real": "f64", "int": "i64", "word": "String", "big": "String"}
_TAKEN = {**_ATOMS, "big": "_"}  # whatever the function takes
_HEAD = re.compile(
    rb"(?:\xef\xbb\xbf)?(?>(?:\s++|#!\[[^\]]*+\]|//[^\n]*+|/\*(?>(?:[^*]++|\*(?!/))*)\*/)*)", re.DOTALL
)


def name_of(shape: Shape, names: Mapping[str, str] = _ATOMS) -> str:
    """The type, the atoms called by `names`."""
    if shape.kind in ("list", "optional"):
        return f"{'Vec' if shape.kind == 'list' else 'Option'}<{name_of(shape.inner, names)}>"
    return shape.name or atom(names, shape)


def defined(shape: Shape) -> str:
    """The definition of a tuple."""
    fields = (f"pub {field}: {name_of(part)}" for part, field in zip(shape.parts, shape.fields, strict=True))
    copy = ", Copy" if _copies(shape) else ""
    return f"#[derive(Clone{copy}, Debug, PartialEq)] pub struct {shape.name} {{ {listed(fields)} }}"


def _copies(shape: Shape) -> bool:
    return shape.kind in ("real", "int") or (shape.kind == "tuple" and all(map(_copies, shape.parts)))


def declared(draft: Draft) -> str:
    """The function's head. Raises Unsupported where integers of any size are within the answer."""
    answer = small(draft.answer)
    if draft._replace(parameters=(), answer=answer).is_big:
        raise Unsupported("big")
    parameters = listed(f"{name.lower()}: {name_of(shape)}" for name, shape in draft.parameters)
    return f"fn {draft.entry}({parameters}) -> {name_of(answer)}"


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    before = ["// An int of any size comes as the text of its digits; as an i128 too, while it fits."]
    before = [*(before if draft.is_big else []), *map(defined, draft.structs)]
    return "\n".join(before), f' {{\n    panic!("{words}")\n}}'


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text. Raises Unsupported as `declared` does."""
    declared(draft)
    reads = " ".join(
        f"let {argument} = <{name_of(shape, _TAKEN)} as Get>::get(words);"
        for argument, (_, shape) in zip(draft.arguments, draft.parameters, strict=True)
    )
    text = _TEMPLATE.replace("@types@", joined(draft.lacking, defined)).replace("@file@", draft.file)
    text = text.replace("@tuples@", joined(draft.structs, lambda shape: _read_and_put(draft, shape)))
    return "judge_driver.rs", text.replace(
        "@call@", f"{reads} super::{draft.entry}({listed(draft.arguments)})"
    )


def adapted(source: bytes) -> bytes:
    """The submission's file as one that is included: without what only a whole crate may begin with."""
    head = _HEAD.match(source)
    assert head is not None
    plain = re.sub(rb"#!\[([^]\[]*+)\]", rb"/*\1 */", head[0])
    return re.sub(rb"(//|/\*)!", rb"\1 ", plain) + source[head.end() :]


def _fields(draft: Draft, shape: Shape) -> tuple[str, ...]:
    """What the fields of a tuple are called: a type of the submission's own has its own names, or only places."""
    found = re.search(rf"\bstruct\s++{shape.name}\s*+(?:\{{([^{{}}]*+)|(\())", draft.text)
    if shape.name not in draft.own or found is None:
        return shape.fields
    own = tuple(re.findall(r"\b(\w++)\s*+:", found[1] or ""))
    if found[2]:
        own = tuple(map(str, range(len(shape.parts))))
    return own if len(own) == len(shape.parts) else shape.fields


def _read_and_put(draft: Draft, shape: Shape) -> str:
    fields = _fields(draft, shape)
    gets = listed(f"{field}: Get::get(w)" for field in fields)
    puts = " out.push(','); ".join(f"self.{field}.put(out);" for field in fields)
    return f"""impl Get for super::{shape.name} {{ fn get(w: &mut Words) -> Self {{ super::{shape.name} {{ {gets} }} }} }}
impl Put for super::{shape.name} {{ fn put(&self, out: &mut String) {{ out.push('['); {puts} out.push(']'); }} }}"""


_TEMPLATE = r"""#![no_main]
#![allow(warnings)]
@types@
include!("@file@");
mod judge_driver {
use super::*;
use std::io::{Read, Write};
use std::os::unix::io::FromRawFd;
extern "C" { fn dup(a: i32) -> i32; fn dup2(a: i32, b: i32) -> i32; fn _exit(a: i32) -> !; }
type Words<'a> = std::iter::Peekable<std::str::SplitAsciiWhitespace<'a>>;
trait Get { fn get(w: &mut Words) -> Self; }
trait Put { fn put(&self, out: &mut String); }
impl Get for f64 { fn get(w: &mut Words) -> Self { w.next().unwrap().parse().unwrap() } }
macro_rules! whole { ($($t:ty)*) => { $(impl Get for $t { fn get(w: &mut Words) -> Self { let word = w.next().unwrap(); word.parse().unwrap_or_else(|_| panic!("{} does not fit into {}", word, stringify!($t))) } })* } }
whole!(i64 i128);
impl Get for String { fn get(w: &mut Words) -> Self { w.next().unwrap().to_string() } }
impl<T: Get> Get for Vec<T> { fn get(w: &mut Words) -> Self { let n = i64::get(w); (0..n).map(|_| T::get(w)).collect() } }
impl<T: Get> Get for Option<T> { fn get(w: &mut Words) -> Self { if w.peek() == Some(&"none") { w.next(); None } else { Some(T::get(w)) } } }
impl Put for f64 { fn put(&self, out: &mut String) { if self.is_finite() { out.push_str(&format!("{:?}", self)) } else { out.push_str(&format!("{{\"type\":\"float\",\"text\":\"{}\"}}", self.to_string().to_lowercase())) } } }
macro_rules! put_whole { ($($t:ty)*) => { $(impl Put for $t { fn put(&self, out: &mut String) { out.push_str(&self.to_string()) } })* } }
put_whole!(i8 i16 i32 i64 i128 u8 u16 u32 u64 usize isize);
impl Put for str { fn put(&self, out: &mut String) { out.push('"'); for c in self.chars() { if c == '"' || c == '\\' || c < ' ' || c > '~' { out.push_str(&format!("\\u{:04x}", (c as u32).min(0xffff))) } else { out.push(c) } } out.push('"'); } }
impl Put for String { fn put(&self, out: &mut String) { self.as_str().put(out) } }
impl Put for &str { fn put(&self, out: &mut String) { (**self).put(out) } }
impl<T: Put> Put for Vec<T> { fn put(&self, out: &mut String) { out.push('['); for (i, v) in self.iter().enumerate() { if i > 0 { out.push(',') } v.put(out) } out.push(']'); } }
impl<T: Put> Put for Option<T> { fn put(&self, out: &mut String) { match self { Some(v) => v.put(out), None => out.push_str("null") } } }
@tuples@
fn text_of(fault: Box<dyn std::any::Any + Send>) -> String {
    fault.downcast_ref::<String>().cloned().or(fault.downcast_ref::<&str>().map(|s| s.to_string())).unwrap_or("a panic".to_string())
}
fn drive() {
    let mut answers = unsafe { let fd = dup(1); dup2(2, 1); std::fs::File::from_raw_fd(fd) };
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).unwrap();
    let mut lines = text.lines();
    let mut out = String::new();
    while let Some(first) = lines.next() {
        let mut head = first.split_ascii_whitespace().peekable();
        let (cases, at_once) = (i64::get(&mut head), i64::get(&mut head));
        for left in (0..cases).rev() {
            let line = lines.next().unwrap();
            let found = std::panic::catch_unwind(move || { let mut all: Words = line.split_ascii_whitespace().peekable(); let words = &mut all; @call@ });
            match found { Ok(v) => { out.push_str("[0,"); v.put(&mut out) } Err(fault) => { out.push_str("[1,"); text_of(fault).put(&mut out) } }
            out.push_str("]\n");
            if at_once == 1 || left == 0 { answers.write_all(out.as_bytes()).unwrap(); out.clear(); }
        }
    }
}
#[no_mangle]
pub extern "C" fn main(_: i32, _: *const *const u8) -> i32 {
    let failed = std::panic::catch_unwind(drive).is_err();
    unsafe { _exit(if failed { 101 } else { 0 }) }
}
}
"""
