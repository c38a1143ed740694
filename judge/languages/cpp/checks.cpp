// Linked into a program that is run once more: the line of the submission where it throws, or a signal ends it.
#include <backtrace.h>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <sys/auxv.h>
#include <typeinfo>
#include <unistd.h>

extern "C" {
int judge_line;  // of the last throw; the driver tells it
void __real___cxa_throw(void*, std::type_info*, void (*)(void*)) __attribute__((noreturn));
void __wrap___cxa_throw(void*, std::type_info*, void (*)(void*)) __attribute__((noreturn));
}
static backtrace_state* state;
static void nothing(void*, const char*, int) {}
static int place(void*, uintptr_t, const char* file, int line, const char*) {
    bool own = file && std::strstr(file, "solution.cpp");
    if (own) judge_line = line;
    return own;  // the innermost is enough
}
static void look() {
    judge_line = 0;
    backtrace_full(state, 1, place, nothing, nullptr);
}
void __wrap___cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*)) {
    look();
    __real___cxa_throw(thrown, type, destroy);
}
static void on_signal(int number) {
    alarm(3);  // where the heap is broken, looking may take for ever
    look();
    if (judge_line) std::fprintf(stderr, "solution.cpp:%d: SIG%s ends it\n", judge_line, sigabbrev_np(number));
    std::raise(number);
}
__attribute__((constructor)) static void begin() {
    state = backtrace_create_state(reinterpret_cast<const char*>(getauxval(AT_EXECFN)), 0, nothing, nullptr);
    stack_t other = {};  // for a stack that is full
    other.ss_size = 1 << 18;
    other.ss_sp = std::malloc(other.ss_size);
    sigaltstack(&other, nullptr);
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
    for (int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(number, &action, nullptr);
}
