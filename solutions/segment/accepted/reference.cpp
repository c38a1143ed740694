// Foot and half-chord, cut at the ends.
//
// Along the line both points are half a chord before and after the foot of the perpendicular, in lengths from A:
// those from 0 to |B - A| are on the segment. Touching and the ends are lengths as well, and both are compared within
// 1e-10 extents.

#include <algorithm>
#include <cmath>
#include <vector>

struct Pt { double x, y; };

std::vector<Pt> circle_segment(double cx, double cy, double r, Pt A, Pt B) {
    double fx = A.x - cx, fy = A.y - cy, dx = B.x - A.x, dy = B.y - A.y;
    double size = std::max({r, std::abs(fx), std::abs(fy), std::abs(B.x - cx), std::abs(B.y - cy)});
    double near = 1e-10 * size;
    std::vector<Pt> found;
    double length = std::hypot(dx, dy);
    if (length == 0) {
        if (std::abs(std::hypot(fx, fy) - r) <= near) found.push_back(A);
        return found;
    }
    double ux = dx / length, uy = dy / length;
    double side = ux * fy - uy * fx, foot = -(ux * fx + uy * fy);
    double gap = r - std::abs(side);
    if (gap < -near) return found;
    auto add = [&](double step) {
        if (foot + step < -near || foot + step > length + near) return;
        found.push_back({cx - side * uy + step * ux, cy + side * ux + step * uy});
    };
    if (gap <= near) {
        add(0);
    } else {
        double half = std::sqrt(gap * (r + std::abs(side)));
        add(-half);
        add(half);
    }
    return found;
}
