// The discriminant in whole numbers.
//
// The line and the circle have as many points in common as Δ = r²·a - k² has roots: two where it is above 0, one at
// 0. With coordinates up to 1e120 it has less than 1,610 bits, so that a number of 1,664 bits holds it exactly.

#include <stdbool.h>
#include <stdint.h>

typedef struct { const char *x, *y; } IntPt;

enum { WORDS = 26 };

// A whole number of 1,664 bits in two's complement, the lowest 64 bits first.
typedef struct { uint64_t words[WORDS]; } Whole;

static Whole sum(Whole a, Whole b, unsigned carry) {
    for (int i = 0; i < WORDS; i++) {
        unsigned __int128 column = (unsigned __int128)a.words[i] + b.words[i] + carry;
        a.words[i] = (uint64_t)column;
        carry = (unsigned)(column >> 64);
    }
    return a;
}

static Whole difference(Whole a, Whole b) {
    for (int i = 0; i < WORDS; i++) b.words[i] = ~b.words[i];
    return sum(a, b, 1);
}

static int sign(Whole a) {
    if (a.words[WORDS - 1] >> 63) return -1;
    for (int i = 0; i < WORDS; i++)
        if (a.words[i]) return 1;
    return 0;
}

static Whole product(Whole a, Whole b) {
    if (sign(a) < 0) return product(difference((Whole){0}, a), difference((Whole){0}, b));  // most words of a are 0
    Whole total = {0};
    for (int i = 0; i < WORDS; i++) {
        if (a.words[i] == 0) continue;
        uint64_t carry = 0;
        for (int j = 0; i + j < WORDS; j++) {
            unsigned __int128 column = (unsigned __int128)a.words[i] * b.words[j] + total.words[i + j] + carry;
            total.words[i + j] = (uint64_t)column;
            carry = (uint64_t)(column >> 64);
        }
    }
    return total;
}

// The number that these decimal digits say, taken eighteen at a time.
static Whole whole(const char *digits) {
    Whole number = {0};
    bool below = *digits == '-';
    uint64_t part = 0, scale = 1;
    for (digits += below; *digits; digits++) {
        part = 10 * part + (*digits - '0');
        scale *= 10;
        if (scale < 1000000000000000000 && digits[1]) continue;
        for (int i = 0; i < WORDS; i++) {
            unsigned __int128 column = (unsigned __int128)number.words[i] * scale + part;
            number.words[i] = (uint64_t)column;
            part = (uint64_t)(column >> 64);
        }
        part = 0;
        scale = 1;
    }
    return below ? difference((Whole){0}, number) : number;
}

bool exact_count(const char *cx, const char *cy, const char *r, IntPt A, IntPt B, long long *out) {
    Whole fx = difference(whole(A.x), whole(cx)), fy = difference(whole(A.y), whole(cy));
    Whole dx = difference(whole(B.x), whole(A.x)), dy = difference(whole(B.y), whole(A.y));
    Whole a = sum(product(dx, dx), product(dy, dy), 0);
    if (sign(a) == 0) return false;
    Whole radius = whole(r), k = difference(product(dx, fy), product(dy, fx));
    *out = 1 + sign(difference(product(product(radius, radius), a), product(k, k)));
    return true;
}
