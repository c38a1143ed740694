// Products kept as two doubles.
//
// b² and a·c may agree in every digit of a double, so each is kept with what it rounds off, which fma gives exactly;
// the difference of both is then as good as that of the exact ones. Of the roots the one that adds comes first, and
// the other one from their product c/a. Everything is scaled by powers of two before, so that no square overflows.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

std::optional<std::vector<double>> quadratic_roots(double a, double b, double c) {
    using Roots = std::vector<double>;
    auto in_order = [](double s, double t) { return Roots{std::min(s, t), std::max(s, t)}; };
    if (a == 0) {
        if (b != 0) return Roots{-c / b / 2};
        if (c == 0) return {};
        return Roots{};
    }
    if (c == 0) return b == 0 ? Roots{0} : in_order(0, -2 * (b / a));

    // With t = 2^half·u both a and c have the size of 2^level.
    int ea, eb, ec;
    double ma = std::frexp(a, &ea), mb = std::frexp(b, &eb), mc = std::frexp(c, &ec);
    if ((ea + ec) % 2 != 0) {
        mc /= 2;
        ++ec;
    }
    int half = (ec - ea) / 2, level = (ea + ec) / 2;
    if (b != 0 && eb - level > 200) return in_order(-2 * (b / a), -(c / b) / 2);  // a·c is nothing beside b²
    mb = std::ldexp(mb, std::max(eb - level, -200));

    double square = mb * mb, product = ma * mc;
    double delta = (square - product) + (std::fma(mb, mb, -square) - std::fma(ma, mc, -product));
    if (delta < 0) return Roots{};
    if (delta == 0) return Roots{std::ldexp(-mb / ma, half)};
    double sum = -(mb + std::copysign(std::sqrt(delta), mb));
    return in_order(std::ldexp(sum / ma, half), std::ldexp(mc / sum, half));
}
