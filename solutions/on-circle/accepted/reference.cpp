// The distance against the radius.
//
// Everything is seen from the centre, so that a small circle far from the origin keeps its digits. The threshold of
// 1e-10 of the size lies between rounding and the nearest miss, 1e-7.

#include <algorithm>
#include <cmath>

struct Pt { double x, y; };

long long on_circle(double cx, double cy, double r, Pt P) {
    double fx = P.x - cx, fy = P.y - cy;
    double near = 1e-10 * std::max({r, std::abs(fx), std::abs(fy)});
    double gap = std::hypot(fx, fy) - r;
    return (gap > near) - (gap < -near);
}
