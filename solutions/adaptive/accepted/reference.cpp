// A filter, and whole numbers behind it.
//
// Δ = r²·a - k² in doubles has the right sign wherever it is larger than a bound of all its roundings. Elsewhere it
// is done in whole numbers: each coordinate is one of less than 253 bits in units of 2⁻¹⁵², and 1,024 bits hold Δ
// exactly.

#include <array>
#include <cmath>
#include <cstdint>

// A whole number of 1,024 bits in two's complement, the lowest 64 bits first.
struct Whole {
    std::array<uint64_t, 16> words{};

    int sign() const {
        if (words.back() >> 63) return -1;
        return words == Whole{}.words ? 0 : 1;
    }
};

static Whole sum(const Whole& a, const Whole& b, unsigned carry = 0) {
    Whole total;
    for (size_t i = 0; i < a.words.size(); ++i) {
        unsigned __int128 column = (unsigned __int128)a.words[i] + b.words[i] + carry;
        total.words[i] = uint64_t(column);
        carry = unsigned(column >> 64);
    }
    return total;
}

static Whole operator+(const Whole& a, const Whole& b) { return sum(a, b); }

static Whole operator-(const Whole& a, Whole b) {
    for (uint64_t& word : b.words) word = ~word;
    return sum(a, b, 1);
}

static Whole operator*(const Whole& a, const Whole& b) {
    if (a.sign() < 0) return (Whole{} - a) * (Whole{} - b);  // so that most words of a are 0
    Whole product;
    for (size_t i = 0; i < a.words.size(); ++i) {
        if (a.words[i] == 0) continue;
        uint64_t carry = 0;
        for (size_t j = 0; i + j < a.words.size(); ++j) {
            unsigned __int128 column = (unsigned __int128)a.words[i] * b.words[j] + product.words[i + j] + carry;
            product.words[i + j] = uint64_t(column);
            carry = uint64_t(column >> 64);
        }
    }
    return product;
}

// x in units of 2⁻¹⁵²: no coordinate has a finer part, for none but 0 is below 1e-30.
static Whole whole(double x) {
    Whole number;
    double rest = std::ldexp(std::abs(x), 152);
    for (int i = 3; i >= 0; --i) {
        number.words[i] = uint64_t(std::ldexp(rest, -64 * i));
        rest -= std::ldexp(double(number.words[i]), 64 * i);
    }
    return x < 0 ? Whole{} - number : number;
}

static int exact_sign(Whole cx, Whole cy, Whole r, Whole ax, Whole ay, Whole bx, Whole by) {
    Whole dx = bx - ax, dy = by - ay;
    Whole k = dx * (ay - cy) - dy * (ax - cx);
    return (r * r * (dx * dx + dy * dy) - k * k).sign();
}

long long delta_sign(double cx, double cy, double r, double ax, double ay, double bx, double by) {
    double dx = bx - ax, dy = by - ay, fx = ax - cx, fy = ay - cy;
    double p = dx * fy, q = dy * fx;
    double k = p - q, m = std::abs(p) + std::abs(q);
    double reach = r * r * (dx * dx + dy * dy);
    double delta = reach - k * k;
    double bound = 1.2e-16 * (16 * reach + 18 * m * std::abs(k)) + 1.3e-30 * m * m;
    if (delta > bound) return 1;
    if (delta < -bound) return -1;
    return exact_sign(whole(cx), whole(cy), whole(r), whole(ax), whole(ay), whole(bx), whole(by));
}
