"""C++: the source is included into the driver, which reads and writes by templates.

An integer of any size is given as its decimal digits in a string, or as a long long or an __int128 where the
function is declared so. An answer may be such a string too.
"""

from __future__ import annotations

from judge.languages.draft import Draft, joined, listed
from judge.languages.shapes import Shape, atom

_ATOMS = {"real": "double", "int": "long long", "word": "std::string", "big": "std::string"}


def name_of(shape: Shape) -> str:
    """The type."""
    if shape.kind in ("list", "optional"):
        return f"std::{'vector' if shape.kind == 'list' else 'optional'}<{name_of(shape.inner)}>"
    return shape.name or atom(_ATOMS, shape)


def defined(shape: Shape) -> str:
    """The definition of a tuple."""
    fields = (f"{name_of(part)} {field};" for part, field in zip(shape.parts, shape.fields, strict=True))
    return f"struct {shape.name} {{ {' '.join(fields)} }};"


def declared(draft: Draft) -> str:
    """The function's head."""
    parameters = (f"{name_of(shape)} {name}" for name, shape in draft.parameters)
    return f"{name_of(_small(draft.answer))} {draft.entry}({listed(parameters)})"


def _small(answer: Shape) -> Shape:
    """The answer with a number of the machine where it is one number: most are counts and signs."""
    if answer.kind == "optional":
        return answer._replace(parts=(_small(answer.inner),))
    return Shape("int") if answer.kind == "big" else answer


def frame(draft: Draft, words: str) -> tuple[str, str]:
    """What stands before the head in a file to begin with, and the body after it."""
    names = ("optional", "stdexcept", "string", "vector")
    before = [*(f"#include <{name}>" for name in names), ""]
    if draft.is_big:
        before.append(
            "// An int of any size comes as the text of its digits; as an __int128 too, while it fits."
        )
    before += map(defined, draft.structs)
    return "\n".join(before).rstrip(), f' {{\n    throw std::logic_error("{words}");\n}}'


def driver(draft: Draft) -> tuple[str, str]:
    """The driver's file name and its text."""
    reads = " ".join(
        f"auto {argument} = {_get(shape)};"
        for argument, (_, shape) in zip(draft.arguments, draft.parameters, strict=True)
    )
    # One integer of any size may be returned as a string, or as any integer of the machine.
    answer = name_of(draft.answer) if draft.answer == _small(draft.answer) else "auto"
    # What is found is looked at as the call left it: nothing may be inferred from it, such as that no int overflows.
    call = f"{answer} judge_found = ::{draft.entry}({listed(draft.arguments)});"
    text = _TEMPLATE.replace("@types@", joined(draft.lacking, defined)).replace("@file@", draft.file)
    text = text.replace("@whole@", _WHOLE if draft.is_big else _NO_WHOLE)
    text = text.replace("@tuples@", joined(draft.structs, _read_and_put))
    return "judge_driver.cpp", text.replace("@call@", f"{reads} {call}")


def _get(shape: Shape) -> str:
    return f"Read<{'Whole' if shape.kind == 'big' else name_of(shape)}>::get()"


def _part(shape: Shape) -> str:
    """A field of a struct that may be the learner's own, of float or int."""
    return f"Number{{{_get(shape)}}}" if shape.kind in ("real", "int") else _get(shape)


def _read_and_put(shape: Shape) -> str:
    name, parts = shape.name, listed(map(_part, shape.parts))
    puts = " judge_out += ','; ".join(f"judge_put(judge_it.{field});" for field in shape.fields)
    return f"""template <> struct Read<{name}> {{ static {name} get() {{ return {name}{{{parts}}}; }} }};
template <> struct Put<{name}> {{ static void it(const {name}& judge_it) {{ judge_out += '['; {puts} judge_out += ']'; }} }};"""


# What reads and writes stands before the source, whose macros and pragmas are none of its business.
_TEMPLATE = r"""#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>
namespace judge_driver {
#ifdef __GLIBC__
#define JUDGE_QUIET noexcept
#else
#define JUDGE_QUIET
#endif
extern "C" { int dup(int) JUDGE_QUIET; int dup2(int, int) JUDGE_QUIET; void _exit(int); } // not all of unistd.h: the source may have a link of its own
static std::string in, judge_out;
static char* at;
static std::FILE* answers;
__attribute__((constructor(101))) static void take_stdout() { answers = fdopen(dup(1), "w"); dup2(2, 1); }
static std::string token() { while (*at && *at <= ' ') ++at; char* from = at; while (*at > ' ') ++at; return std::string(from, at); }
template <class T> struct Number { T value; template <class U, class = std::enable_if_t<std::is_arithmetic_v<U>>> operator U() const { return (U)value; } };
template <class T> struct Read;
#ifdef __cpp_lib_to_chars
template <> struct Read<double> { static double get() { while (*at == ' ') ++at; double v = 0; at += std::from_chars(at, in.data() + in.size(), v).ptr - at; return v; } };
#else
template <> struct Read<double> { static double get() { return std::strtod(at, &at); } };
#endif
template <> struct Read<long long> { static long long get() { return std::strtoll(at, &at, 10); } };
template <> struct Read<std::string> { static std::string get() { return token(); } };
template <class T> struct Read<std::vector<T>> { static std::vector<T> get() { std::vector<T> v; for (long long n = Read<long long>::get(); n > 0; --n) v.push_back(Read<T>::get()); return v; } };
template <class T> struct Read<std::optional<T>> { static std::optional<T> get() { char* before = at; if (token() == "none") return {}; at = before; return Read<T>::get(); } };
template <class T, class = void> struct Put;
template <class T> static void judge_put(const T& v) { Put<T>::it(v); }
@whole@
static void text(const std::string& s) { judge_out += '"'; for (unsigned char c : s) { char b[8]; if (c == '"' || c == '\\' || c < 32 || c > 126) { std::snprintf(b, 8, "\\u%04x", c); judge_out += b; } else judge_out += char(c); } judge_out += '"'; }
template <> struct Put<std::string> { static void it(const std::string& s) { if (is_whole(s)) judge_out += s; else text(s); } };
template <class T> struct Put<T, std::enable_if_t<std::is_floating_point_v<T>>> { static void it(double v) { char b[64]; if (std::isfinite(v)) judge_out.append(b, std::to_chars(b, b + 64, v).ptr); else { judge_out += "{\"type\":\"float\",\"text\":"; text(std::isnan(v) ? "nan" : v < 0 ? "-inf" : "inf"); judge_out += '}'; } } };
template <class T> struct Put<T, std::enable_if_t<std::is_integral_v<T>>> { static void it(T v) { if constexpr (sizeof v <= 8) judge_out += std::to_string(v); else { if (v < 0 && v > -10) judge_out += '-'; if (v / 10) it(v / 10); int digit = int(v % 10); judge_out += char('0' + (digit < 0 ? -digit : digit)); } } };
template <class T> struct Put<std::vector<T>> { static void it(const std::vector<T>& v) { judge_out += '['; for (size_t i = 0; i < v.size(); ++i) { if (i) judge_out += ','; judge_put<T>(v[i]); } judge_out += ']'; } };
template <class T> struct Put<std::optional<T>> { static void it(const std::optional<T>& v) { if (v) judge_put(*v); else judge_out += "null"; } };
static void flush() { if (std::fwrite(judge_out.data(), 1, judge_out.size(), answers) != judge_out.size() || std::fflush(answers)) _exit(1); judge_out.clear(); }
static int drive(void (*answer)()) {
    char block[1 << 16];
    size_t n;
    while ((n = std::fread(block, 1, sizeof block, stdin)) > 0) in.append(block, n);
    at = in.data();
    for (char* end = at + in.size(); at < end;) {
        long long cases = Read<long long>::get(), at_once = Read<long long>::get();
        for (++at; cases > 0; --cases) {
            char* line = std::find(at, end, '\n');
            try { answer(); }
            catch (const std::bad_alloc&) { flush(); throw; }
            catch (const std::exception& e) { judge_out += "[1,"; text(e.what()); }
            catch (...) { judge_out += "[1,"; text("an exception that is no std::exception"); }
            at = line + 1;
            judge_out += "]\n";
            if (at_once) flush();
        }
        flush();
    }
    std::fflush(stdout);
    _exit(0);
}
}
@types@
#define main judge_the_learners_main
#include "@file@"
#undef main
#undef int
#undef double
namespace judge_driver {
@tuples@
static void judge_answer() { @call@ __asm__ volatile("" : : "g"(&judge_found) : "memory"); judge_out += "[0,"; judge_put(judge_found); }
}
int main() { return judge_driver::drive(judge_driver::judge_answer); }
"""

# An integer of any size, for whatever the function takes, and back from what it returns.
_WHOLE = r"""struct Whole {  // an integer of any size, for whatever the function takes
    std::string digits;
    operator std::string() const { return digits; }
    operator __int128() const { return fit(~((unsigned __int128)1 << 127), "__int128"); }
    operator long long() const { return (long long)fit(~0ULL >> 1, "long long"); }
    __int128 fit(unsigned __int128 most, const char* type) const {
        bool below = digits[0] == '-';
        unsigned __int128 n = 0;
        for (size_t i = below; i < digits.size(); n = 10 * n + (digits[i++] - '0'))
            if (n > (most + below - (digits[i] - '0')) / 10) throw std::out_of_range(digits + " does not fit into " + type);
        return (__int128)(below ? -n : n);
    }
};
template <> struct Read<Whole> { static Whole get() { return Whole{token()}; } };
static bool is_whole(const std::string& s) { size_t i = s[0] == '-'; return s.size() > i && s.find_first_not_of("0123456789", i) == s.npos && (s[i] != '0' || s == "0"); }"""

_NO_WHOLE = "static bool is_whole(const std::string&) { return false; }"
