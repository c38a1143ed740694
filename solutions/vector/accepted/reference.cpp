// One pass over the arrays.
//
// The numbers of all circles lie one after the other, so that a plain loop reads memory in order. Each circle has its
// own size, and its distance from the line is compared with its radius within 1e-10 of that.

#include <algorithm>
#include <cmath>
#include <vector>

struct Pt { double x, y; };

std::vector<long long> count_many(const std::vector<double>& cx, const std::vector<double>& cy,
                                  const std::vector<double>& r, Pt A, Pt B) {
    double dx = B.x - A.x, dy = B.y - A.y, length = std::hypot(dx, dy);
    std::vector<long long> counts(r.size());
    for (size_t i = 0; i < r.size(); ++i) {
        double fx = A.x - cx[i], fy = A.y - cy[i], gx = B.x - cx[i], gy = B.y - cy[i];
        double near = 1e-10 * std::max({r[i], std::abs(fx), std::abs(fy), std::abs(gx), std::abs(gy)});
        double gap = std::abs(dx * fy - dy * fx) / length - r[i];
        counts[i] = (gap <= near) + (gap < -near);
    }
    return counts;
}
