"""Attacks in other languages: programs in C that print BREACH where they get through, and sources that attack
the compiler. `@name@` stands for a target of driver.py.

`RUN` are C functions' bodies that give 1 where the attack worked; `COMPILE` are sources whose program prints
what it must not know, and its beginning; `BOMBS` are sources that take a compiler's time, memory or disk.
`SOURCES` are all of them as they are compiled.
"""

# ruff: noqa: E501 - programs in C

from __future__ import annotations

from itertools import pairwise

HEAD = r"""
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
static int opens(const char *path) { int f = open(path, O_RDONLY); char c; return f >= 0 && read(f, &c, 1) == 1; }
static int lists(const char *path) { DIR *d = opendir(path); return d && readdir(d); }
static int attack(void) { BODY }
int main(void) { int worked = attack(); puts(worked ? "BREACH" : "held"); return 0; }
"""

RUN = {
    "read_passwd": 'return opens("/etc/passwd");',
    "read_shadow": 'return opens("/etc/shadow");',
    "privileged": 'FILE *f = fopen("/proc/self/status", "r"); char s[256]; while (f && fgets(s, 256, f)) if (!strncmp(s, "CapEff:", 7) && strtoull(s + 7, 0, 16)) return 1; return 0;',
    "read_answers": 'return opens("@secret@");',
    "read_through_a_link": 'return opens("@link@");',
    "read_home": 'return opens("@home_file@");',
    "list_judge": 'return lists("@judge_folder@");',
    "list_root": 'return lists("/");',
    "make_file": 'return open("@folder@/new-file", O_CREAT | O_WRONLY, 0600) >= 0;',
    "make_folder": 'return mkdir("@folder@/new-folder", 0700) == 0;',
    "make_link": 'return symlink("/etc/passwd", "@folder@/new-link") == 0;',
    "remove_file": 'int f = open("@folder@/made", O_CREAT | O_WRONLY, 0600); return f >= 0 && unlink("@folder@/made") == 0;',
    "change_folder": 'return chdir("@folder@") == 0;',
    "fork": "int p = fork(); if (!p) _exit(0); return p > 0;",
    "vfork": "int p = vfork(); if (!p) _exit(0); return p > 0;",
    "clone": "int p = syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0); if (!p) _exit(0); return p > 0;",
    "clone3": "struct { unsigned long a[11]; } args = {{0}}; args.a[4] = SIGCHLD; int p = syscall(435, &args, 88); if (!p) _exit(0); return p > 0;",
    "shell": 'execl("/bin/sh", "sh", "-c", "echo BREACH", (char *)0); return 0;',
    "interpreter": 'execl("@python@", "python3", "-c", "print(\'BREACH\')", (char *)0); return 0;',
    "system": 'return system("true") == 0;',
    "program_in_memory": (
        'int f = syscall(SYS_memfd_create, "x", 0); int g = open("/bin/true", O_RDONLY); char b[1 << 16]; ssize_t n; '
        "while ((n = read(g, b, sizeof b)) > 0) if (write(f, b, n) < 0) return 0; "
        'int p = vfork(); if (!p) { char *a[] = {"x", 0}, *e[] = {0}; syscall(SYS_execveat, f, "", a, e, AT_EMPTY_PATH); _exit(9); } '
        "int s = 0; return p > 0 && waitpid(p, &s, 0) == p && WIFEXITED(s) && WEXITSTATUS(s) == 0;"
    ),
    "connect": "struct sockaddr_in a = {AF_INET, htons(@port@), {htonl(INADDR_LOOPBACK)}}; return connect(socket(AF_INET, SOCK_STREAM, 0), (void *)&a, sizeof a) == 0;",
    "unix_socket": 'struct sockaddr_un a = {AF_UNIX, "@unix_stream@"}; return connect(socket(AF_UNIX, SOCK_STREAM, 0), (void *)&a, sizeof a) == 0;',
    "signal_judge": "return kill(@judge_pid@, 0) == 0;",
    "signal_victim": "return kill(@victim_pid@, SIGCONT) == 0;",
    "signal_all": "return kill(-1, 0) == 0;",
    "read_memory": "char b[8]; struct iovec mine = {b, 8}, theirs = {(void *)@victim_address@, 8}; return process_vm_readv(@victim_pid@, &mine, 1, &theirs, 1, 0) == 8;",
    "trace": "return ptrace(PTRACE_TRACEME, 0, 0, 0) == 0;",
    "new_session": "return setsid() > 0 || setpgid(0, 0) == 0;",
    "namespace": "return unshare(CLONE_NEWUSER) == 0;",
    "shared_memory": "void *p = mmap(0, 900 << 20, 3, MAP_SHARED | MAP_ANONYMOUS, -1, 0); if (p == MAP_FAILED) return 0; memset(p, 1, 600 << 20); return 1;",
    "file_in_memory": 'int f = syscall(SYS_memfd_create, "x", 0); return f >= 0 && ftruncate(f, 600 << 20) == 0;',
    "posix_shared_memory": 'int f = open("/dev/shm/judge-@judge_pid@", O_CREAT | O_RDWR, 0600); unlink("/dev/shm/judge-@judge_pid@"); return f >= 0;',
    "other_abi": 'long n = 20, p; __asm__ volatile("int $0x80" : "=a"(p) : "a"(n) : "memory"); return p > 0;',
    "second_table": "return syscall(0x40000000 | SYS_getpid) > 0;",
    "outer_descriptors": "for (int f = 3; f < 64; f++) if (fcntl(f, F_GETFD) >= 0) return 1; return 0;",
    "rewrite_itself": 'int f = open("/proc/self/exe", O_WRONLY); int g = open("main", O_WRONLY); return f >= 0 || g >= 0 || chmod(".", 0777) == 0;',
}

MAYBE = {  # what some kernels, or no plain user, or nobody at all may do even without containment
    *("clone3", "namespace", "second_table", "other_abi", "outer_descriptors", "read_memory", "trace"),
    *("read_shadow", "privileged", "signal_all", "rewrite_itself", "posix_shared_memory"),
}

ASSEMBLED = r"""
#include <stdio.h>
__asm__(".global s\ns: .incbin \"FILE\"\n.byte 0\n.section .note.GNU-stack,\"\"");
extern char s[];
int main(void) { puts(s); }
"""
COMPILE = {
    "include_passwd": ('#include "/etc/passwd"\n', "root:"),
    "include_answers": ('#include "@secret@"\n', "EXPECTED"),
    "assemble_answers": (ASSEMBLED.replace("FILE", "@secret@"), "EXPECTED"),
    "assemble_judge": (ASSEMBLED.replace("FILE", "@judge_file@"), "JudgeError"),
}

BOMBS = {
    "endless_include": '#include "/dev/urandom"\nint main(void) {}\n',
    "itself": "#include __FILE__\n#include __FILE__\nint main(void) {}\n",
    "large": "char a[3u << 30] = {1};\nint main(void) { return a[1]; }\n",
    "doubling": (
        "#define a 1,\n"
        + "".join(
            f"#define {after} {' '.join(before * 4)}\n" for before, after in pairwise("abcdefghijklmnopq")
        )
        + "int x[] = {q};\nint main(void) {}\n"
    ),
    "assembled": '__asm__(".rept 2000000000\\n.quad 1\\n.endr");\nint main(void) {}\n',
}

SOURCES = {name: HEAD.replace("BODY", body) for name, body in RUN.items()}
SOURCES |= {name: source for name, (source, _) in COMPILE.items()} | BOMBS
