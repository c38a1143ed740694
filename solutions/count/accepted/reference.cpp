// The distance against the radius.
//
// Seen from the centre the cross product of B - A and A - C is |B - A| times the line's distance, wherever A and B
// are on the line. The distance is compared with r within 1e-10 of the size, more than rounding and less than the
// nearest miss.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<long long> line_count(double cx, double cy, double r, Pt A, Pt B) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double fx = A.x - cx, fy = A.y - cy;
    double size = std::max({r, std::abs(fx), std::abs(fy), std::abs(B.x - cx), std::abs(B.y - cy)});
    double near = 1e-10 * size;
    double gap = std::abs(dx * fy - dy * fx) / std::hypot(dx, dy) - r;
    if (gap > near) return 0;
    return gap < -near ? 2 : 1;
}
