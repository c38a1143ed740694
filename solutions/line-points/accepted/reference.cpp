// Foot and half-chord.
//
// The foot of the perpendicular from the centre is the middle of both points: from there it is the same way back and
// forth. The cross product of the unit vector u and A - C says how far the foot is from C and on which side, however
// far A is; back comes before forth on the way from A to B.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

struct Pt { double x, y; };

std::optional<std::vector<Pt>> line_points(double cx, double cy, double r, Pt A, Pt B) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double fx = A.x - cx, fy = A.y - cy;
    double size = std::max({r, std::abs(fx), std::abs(fy), std::abs(B.x - cx), std::abs(B.y - cy)});
    double near = 1e-10 * size;
    double length = std::hypot(dx, dy), ux = dx / length, uy = dy / length;
    double side = ux * fy - uy * fx;
    Pt foot = {cx - side * uy, cy + side * ux};
    double gap = r - std::abs(side);
    if (gap < -near) return std::vector<Pt>{};
    if (gap <= near) return std::vector<Pt>{foot};
    double half = std::sqrt(gap * (r + std::abs(side)));
    return std::vector<Pt>{{foot.x - half * ux, foot.y - half * uy}, {foot.x + half * ux, foot.y + half * uy}};
}
