// Half-chord, and the power of the origin.
//
// The ways along the ray to both points are the foot's, less and more half a chord. Where these would cancel, the
// smaller way is taken from their product, which is the power of O: |f|² - r². A way within 1e-10 extents of 0 is 0.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<double> ray_nearest(double cx, double cy, double r, Pt O, Pt D) {
    double length = std::hypot(D.x, D.y);
    if (length == 0) return {};
    double ux = D.x / length, uy = D.y / length, fx = O.x - cx, fy = O.y - cy;
    double near = 1e-10 * std::max({r, std::abs(fx), std::abs(fy)});
    double d = std::abs(D.x * fy - D.y * fx) / length;
    if (d > r + near) return {};
    double foot = -(ux * fx + uy * fy), first = foot, second = foot;
    if (d < r - near) {
        double half = std::sqrt((r - d) * (r + d)), power = fx * fx + fy * fy - r * r;
        if (foot >= 0) {
            second = foot + half;
            first = power / second;
        } else {
            first = foot - half;
            second = power / first;
        }
    }
    for (double way : {first, second}) {
        if (std::abs(way) <= near) return 0;
        if (way > 0) return way / length;
    }
    return {};
}
