// The discriminant in whole numbers.
//
// The line and the circle have as many points in common as Δ = r²·a - k² has roots: two where it is above 0, one at
// 0. With coordinates up to 1e120 it has less than 1,610 bits, so that a number of 1,664 bits holds it exactly.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

struct IntPt { std::string x, y; };

// A whole number of 1,664 bits in two's complement, the lowest 64 bits first.
struct Whole {
    std::array<uint64_t, 26> words{};

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

// The number that these decimal digits say, taken eighteen at a time.
static Whole whole(const std::string& digits) {
    Whole number;
    uint64_t part = 0, scale = 1;
    for (size_t i = digits[0] == '-'; i < digits.size(); ++i) {
        part = 10 * part + (digits[i] - '0');
        scale *= 10;
        if (scale < 1'000'000'000'000'000'000 && i + 1 < digits.size()) continue;
        for (uint64_t& word : number.words) {
            unsigned __int128 column = (unsigned __int128)word * scale + part;
            word = uint64_t(column);
            part = uint64_t(column >> 64);
        }
        part = 0, scale = 1;
    }
    return digits[0] == '-' ? Whole{} - number : number;
}

std::optional<long long> exact_count(std::string cx, std::string cy, std::string r, IntPt A, IntPt B) {
    Whole fx = whole(A.x) - whole(cx), fy = whole(A.y) - whole(cy);
    Whole dx = whole(B.x) - whole(A.x), dy = whole(B.y) - whole(A.y);
    Whole a = dx * dx + dy * dy;
    if (a.sign() == 0) return {};
    Whole radius = whole(r), k = dx * fy - dy * fx;
    return 1 + (radius * radius * a - k * k).sign();
}
