#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int dup(int), dup2(int, int); /* not all of unistd.h: the source may call something of its own read or link */
void _exit(int);
static char *judge_at;
static FILE *judge_out;
__attribute__((constructor(101))) static void judge_take_stdout(void) { judge_out = fdopen(dup(1), "w"); dup2(2, 1); }
static double judge_real(void) { return strtod(judge_at, &judge_at); }
static long long judge_int(void) { return strtoll(judge_at, &judge_at, 10); }
static const char *judge_token(void) {
    while (*judge_at && *judge_at <= ' ') judge_at++;
    char *from = judge_at;
    while (*judge_at > ' ') judge_at++;
    char *v = strndup(from, judge_at - from);
    if (*v != '=') return v;
    char *to = v;
    for (char *at = v + 1; at[0]; at += 2) { int n = 0; for (int i = 0; i < 2; i++) n = 16 * n + (at[i] <= '9' ? at[i] - '0' : at[i] - 'a' + 10); *to++ = n; }
    *to = 0;
    return v;
}
static bool judge_bool(void) { return !strcmp(judge_token(), "true"); }
static void judge_put_bool(bool v) { fputs(v ? "true" : "false", judge_out); }
static void judge_put_digits(const char *v) { fputs(v && *v ? v : "null", judge_out); }
static void judge_put_int(long long v) { fprintf(judge_out, "%lld", v); }
static void judge_put_real(double v) { if (isfinite(v)) fprintf(judge_out, "%.17g", v); else fprintf(judge_out, "{\"type\":\"float\",\"text\":\"%s\"}", isnan(v) ? "nan" : v < 0 ? "-inf" : "inf"); }
static void judge_put_word(const char *v) { if (!v) { fputs("null", judge_out); return; } fputc('"', judge_out); for (; *v; v++) if (*v == '"' || *v == '\\' || *v < 32 || *v > 126) fprintf(judge_out, "\\u%04x", (unsigned char)*v); else fputc(*v, judge_out); fputc('"', judge_out); }
static int judge_drive(void (*answer)(void)) {
    size_t size = 0, room = 1 << 16;
    char *in = malloc(room + 1);
    size_t n;
    while ((n = fread(in + size, 1, room - size, stdin)) > 0) { size += n; if (size == room) in = realloc(in, (room *= 2) + 1); }
    in[size] = 0;
    for (judge_at = in; judge_at < in + size;) {
        long long cases = judge_int(), at_once = judge_int();
        for (judge_at++; cases > 0; cases--) {
            char *line = strchr(judge_at, '\n');
            answer();
            judge_at = line ? line + 1 : in + size;
            if (at_once) fflush(judge_out);
        }
        fflush(judge_out);
    }
    _exit(fclose(judge_out) != 0);
}
@lacking@
#define main judge_the_learners_main
#include "@file@"
#undef main
#undef int
#undef double
#pragma GCC diagnostic error "-Wincompatible-pointer-types"
#pragma GCC diagnostic error "-Wint-conversion"
@tuples@
static void judge_answer(void) { fputs("[0,", judge_out); @reads@ @answered@ fputs("]\n", judge_out); }
int main(void) { return judge_drive(judge_answer); }
