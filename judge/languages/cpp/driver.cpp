#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <exception>
// @if dicts
#include <map>
// @end
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <typeinfo>
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
static int hex(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }
template <> struct Read<std::string> { static std::string get() { std::string s = token(); if (s[0] != '=') return s; std::string v; for (size_t i = 1; i + 1 < s.size(); i += 2) v += char(16 * hex(s[i]) + hex(s[i + 1])); return v; } };
template <> struct Read<bool> { static bool get() { return token() == "true"; } };
template <class T> struct Read<std::vector<T>> { static std::vector<T> get() { std::vector<T> v; for (long long n = Read<long long>::get(); n > 0; --n) v.push_back(Read<T>::get()); return v; } };
template <class T> struct Read<std::optional<T>> { static std::optional<T> get() { char* before = at; if (token() == "none") return {}; at = before; return Read<T>::get(); } };
template <class T, class = void> struct Put;
template <class T> static void judge_put(const T& v) { Put<T>::it(v); }
// @if big
struct Whole {  // an integer of any size, for whatever the function takes
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
// @end
// @if digits
static bool is_whole(const std::string& s) { size_t i = s[0] == '-'; return s.size() > i && s.find_first_not_of("0123456789", i) == s.npos && (s[i] != '0' || s == "0"); }
// @end
// @if not digits
static bool is_whole(const std::string&) { return false; }
// @end
static void escaped(unsigned code) { char b[16]; std::snprintf(b, 16, "\\u%04x", code); judge_out += b; }
static size_t more(const std::string& s, size_t i, unsigned& code) {  // how many bytes a character of UTF-8 goes on, 0 where it is none
    unsigned c = code;
    size_t n = c < 0xC2 ? 0 : c < 0xE0 ? 1 : c < 0xF0 ? 2 : c < 0xF5 ? 3 : 0;
    for (size_t k = 1; k <= n; ++k) if (i + k >= s.size() || ((unsigned char)s[i + k] & 0xC0) != 0x80) return 0;
    code = n ? c & (0x3F >> n) : c;
    for (size_t k = 1; k <= n; ++k) code = code << 6 | ((unsigned char)s[i + k] & 0x3F);
    return n;
}
static void text(const std::string& s) {
    judge_out += '"';
    for (size_t i = 0; i < s.size(); ++i) {
        unsigned c = (unsigned char)s[i];
        i += more(s, i, c);
        if (c > 0xFFFF) { escaped(0xD800 + ((c - 0x10000) >> 10)); c = 0xDC00 + (c & 0x3FF); }
        if (c == '"' || c == '\\' || c < 32 || c > 126) escaped(c); else judge_out += char(c);
    }
    judge_out += '"';
}
template <> struct Put<std::string> { static void it(const std::string& s) { if (is_whole(s)) judge_out += s; else text(s); } };
template <class T> struct Put<T, std::enable_if_t<std::is_floating_point_v<T>>> { static void it(double v) { char b[64]; if (std::isfinite(v)) judge_out.append(b, std::to_chars(b, b + 64, v).ptr); else { judge_out += "{\"type\":\"float\",\"text\":"; text(std::isnan(v) ? "nan" : v < 0 ? "-inf" : "inf"); judge_out += '}'; } } };
template <class T> struct Put<T, std::enable_if_t<std::is_integral_v<T>>> { static void it(T v) { if constexpr (sizeof v <= 8) judge_out += std::to_string(v); else { if (v < 0 && v > -10) judge_out += '-'; if (v / 10) it(v / 10); int digit = int(v % 10); judge_out += char('0' + (digit < 0 ? -digit : digit)); } } };
// @if bools
template <> struct Put<bool> { static void it(bool v) { judge_out += v ? "true" : "false"; } };
// @end
template <class T> struct Put<std::vector<T>> { static void it(const std::vector<T>& v) { judge_out += '['; for (size_t i = 0; i < v.size(); ++i) { if (i) judge_out += ','; judge_put<T>(v[i]); } judge_out += ']'; } };
template <class T> struct Put<std::optional<T>> { static void it(const std::optional<T>& v) { if (v) judge_put(*v); else judge_out += "null"; } };
// @if dicts
template <class K, class V> struct Read<std::map<K, V>> { static std::map<K, V> get() { std::map<K, V> v; for (long long n = Read<long long>::get(); n > 0; --n) { K key = Read<K>::get(); v.emplace(key, Read<V>::get()); } return v; } };
template <class K, class V> struct Put<std::map<K, V>> { static void it(const std::map<K, V>& v) { judge_out += "{\"dict\":["; const char* gap = "["; for (const auto& each : v) { judge_out += gap; judge_put<K>(each.first); judge_out += ','; judge_put<V>(each.second); judge_out += ']'; gap = ",["; } judge_out += "]}"; } };
// @end
static std::string name_of(const std::type_info& type) { char* name = abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr); std::string all = name ? name : type.name(); std::free(name); return all; }
static void flush() { if (std::fwrite(judge_out.data(), 1, judge_out.size(), answers) != judge_out.size() || std::fflush(answers)) _exit(1); judge_out.clear(); }
extern "C" __attribute__((weak)) int judge_line;  // of checks.cpp, where that is linked
static long long judge_call;  // which one of calls in a row is made
// @if methods
template <class T> struct Held { T* it; ~Held() { delete it; } };  // of memory's, which brings the names of unistd.h
template <class T> static void each_call(T one) { long long n = Read<long long>::get(); judge_out += '['; for (judge_call = 1; judge_call <= n; ++judge_call) { if (judge_call > 1) judge_out += ','; one(Read<std::string>::get()); } judge_out += ']'; }
// @end
static std::string in_call() { return (&judge_line && judge_line ? " (line " + std::to_string(judge_line) + ")" : "") + (judge_call ? ", in call " + std::to_string(judge_call) : ""); }
static int drive(void (*answer)()) {
    char block[1 << 16];
    size_t n;
    while ((n = std::fread(block, 1, sizeof block, stdin)) > 0) in.append(block, n);
    at = in.data();
    for (char* end = at + in.size(); at < end;) {
        long long cases = Read<long long>::get(), at_once = Read<long long>::get();
        for (++at; cases > 0; --cases) {
            char* line = std::find(at, end, '\n');
            size_t start = judge_out.size();
            judge_call = 0;
            try { answer(); }
            catch (const std::bad_alloc&) { flush(); throw; }
            catch (const std::exception& e) { judge_out.resize(start); judge_out += "[1,"; text(name_of(typeid(e)) + ": " + e.what() + in_call()); }
            catch (...) { judge_out.resize(start); judge_out += "[1,"; text("an exception of type " + name_of(*abi::__cxa_current_exception_type()) + in_call()); }
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
@lacking@
#define main judge_the_learners_main
#include "@file@"
#undef main
#undef int
#undef double
namespace judge_driver {
@tuples@
// @if methods
static void judge_answer() {
    @reads@
    Held<::@entry@> judge_object{new ::@entry@(@arguments@)};
    judge_out += "[0,";
    each_call([&](const std::string& judge_name) {
    @calls@
    });
}
// @end
// @if not methods
static void judge_answer() { @reads@ @answer.returned@ judge_found = ::@entry@(@arguments@); __asm__ volatile("" : : "g"(&judge_found) : "memory"); judge_out += "[0,"; judge_put(judge_found); }
// @end
}
int main() { return judge_driver::drive(judge_driver::judge_answer); }
