// A bound of all roundings.
//
// Each operation is off by at most 2⁻⁵³ of its result. The products p and q are off by three such units, so k² by
// 8·u·M·|k| + 16·u²·M² and one more, with M = |p| + |q|, and r²·a by less than 8·u of itself; the constants below are
// larger by half. Δ = r²·a - k² has no terms larger than what it is made of, so that the bound is narrow.

#include <cmath>

struct Enclosure { double lo, hi; };

Enclosure delta_enclosure(double cx, double cy, double r, double ax, double ay, double bx, double by) {
    const double u = 0x1p-53;
    double dx = bx - ax, dy = by - ay, fx = ax - cx, fy = ay - cy;
    double p = dx * fy, q = dy * fx;
    double k = p - q, m = std::abs(p) + std::abs(q);
    double reach = r * r * (dx * dx + dy * dy);
    double delta = reach - k * k;
    double bound = u * (12 * reach + 16 * m * std::abs(k)) + 64 * u * u * m * m;
    if (bound == 0) return {0, 0};
    return {std::nextafter(delta - bound, -INFINITY), std::nextafter(delta + bound, INFINITY)};
}
