// Relative motion.
//
// Seen from the second disc the first one moves along D, the difference of both ways. Let the second disc grow to r +
// s and the first one shrink to a point: when does a ray meet a circle? It does half a chord before the foot.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<double> balls_meet(Pt P0, Pt P1, double r, Pt Q0, Pt Q1, double s) {
    double reach = r + s, size = reach;
    for (Pt p : {P1, Q0, Q1}) size = std::max({size, std::abs(p.x - P0.x), std::abs(p.y - P0.y)});
    double near = 1e-10 * size;
    double fx = P0.x - Q0.x, fy = P0.y - Q0.y;
    if (std::hypot(fx, fy) <= reach + near) return 0;
    double dx = (P1.x - P0.x) - (Q1.x - Q0.x), dy = (P1.y - P0.y) - (Q1.y - Q0.y);
    double length = std::hypot(dx, dy);
    if (length == 0) return {};
    double d = std::abs(dx * fy - dy * fx) / length;
    if (d > reach + near) return {};
    double first = -(dx * fx + dy * fy) / length;
    if (d < reach - near) first -= std::sqrt((reach - d) * (reach + d));
    if (first < 0 || first > length + near) return {};
    return first / length;
}
