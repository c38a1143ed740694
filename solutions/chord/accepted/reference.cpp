// Half-chord by Pythagoras.
//
// The centre, the foot of the perpendicular and an end of the chord make a right-angled triangle with the long side
// r. Whether the line touches is decided by lengths before the root is taken, and (r - d)(r + d) keeps the digits
// that r² - d² loses.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<double> chord_length(double cx, double cy, double r, Pt A, Pt B) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double fx = A.x - cx, fy = A.y - cy;
    double size = std::max({r, std::abs(fx), std::abs(fy), std::abs(B.x - cx), std::abs(B.y - cy)});
    double near = 1e-10 * size;
    double d = std::abs(dx * fy - dy * fx) / std::hypot(dx, dy);
    if (d > r + near) return {};
    if (d >= r - near) return 0;
    return 2 * std::sqrt((r - d) * (r + d));
}
