#![no_main]
#![allow(warnings)]
@lacking@
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
impl Get for String {
    fn get(w: &mut Words) -> Self {
        let word = w.next().unwrap();
        if !word.starts_with('=') { return word.to_string() }
        (1..word.len()).step_by(2).map(|i| u8::from_str_radix(&word[i..i + 2], 16).unwrap() as char).collect()
    }
}
impl Get for bool { fn get(w: &mut Words) -> Self { w.next() == Some("true") } }
impl Put for bool { fn put(&self, out: &mut String) { out.push_str(if *self { "true" } else { "false" }) } }
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
// @if dicts
macro_rules! maps { ($($t:ident: $($bound:ident)*;)*) => { $(
    impl<K: Get + $($bound +)*, V: Get> Get for std::collections::$t<K, V> { fn get(w: &mut Words) -> Self { let n = i64::get(w); (0..n).map(|_| { let key = K::get(w); (key, V::get(w)) }).collect() } }
    impl<K: Put, V: Put> Put for std::collections::$t<K, V> { fn put(&self, out: &mut String) { out.push_str("{\"dict\":["); for (i, (key, v)) in self.iter().enumerate() { out.push_str(if i > 0 { ",[" } else { "[" }); key.put(out); out.push(','); v.put(out); out.push(']') } out.push_str("]}") } }
)* } }
use std::hash::Hash;
maps!(HashMap: Eq Hash; BTreeMap: Ord;);
// @end
@tuples@
fn text_of(fault: Box<dyn std::any::Any + Send>) -> String {
    fault.downcast_ref::<String>().cloned().or(fault.downcast_ref::<&str>().map(|s| s.to_string())).unwrap_or("what is no text".to_string())
}
static LINE: std::sync::atomic::AtomicU32 = std::sync::atomic::AtomicU32::new(0);
fn place() -> String {
    let line = LINE.load(std::sync::atomic::Ordering::Relaxed);
    if line > 0 { format!(" (line {})", line) } else { String::new() }
}
fn drive() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |told| {
        let line = told.location().filter(|at| at.file().ends_with("@file@")).map_or(0, |at| at.line());
        LINE.store(line, std::sync::atomic::Ordering::Relaxed);
        before(told)
    }));
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
            LINE.store(0, std::sync::atomic::Ordering::Relaxed);
            let found = std::panic::catch_unwind(move || { let mut all: Words = line.split_ascii_whitespace().peekable(); let words = &mut all; @reads@ super::@entry@(@arguments@) });
            match found { Ok(v) => { out.push_str("[0,"); v.put(&mut out) } Err(fault) => { out.push_str("[1,"); format!("panic: {}{}", text_of(fault), place()).put(&mut out) } }
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
