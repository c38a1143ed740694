// A unit normal for each tangent.
//
// Seen from C1 a tangent is X·n = r1, and the other centre v has v·n = r1 - r2 for an outer tangent or r1 + r2 for an
// inner one. With that number q, n is q/d along v and √(d² - q²)/d beside it, to the left and to the right.

#include <algorithm>
#include <cmath>
#include <vector>

struct Pt { double x, y; };

std::vector<Pt> common_tangents(double cx1, double cy1, double r1, double cx2, double cy2, double r2) {
    double vx = cx2 - cx1, vy = cy2 - cy1, d = std::hypot(vx, vy);
    double near = 1e-10 * std::max({r1, r2, std::abs(vx), std::abs(vy)});
    double ux = vx / d, uy = vy / d;
    std::vector<Pt> found;
    auto add = [&](double c, double s) {
        found.push_back({cx1 + r1 * (c * ux - s * uy), cy1 + r1 * (c * uy + s * ux)});
    };
    for (double q : {r1 - r2, r1 + r2}) {
        double gap = d - std::abs(q);
        if (gap < -near) continue;
        if (gap <= near) {
            add(q > 0 ? 1 : -1, 0);
        } else {
            double h = std::sqrt((d - q) * (d + q)) / d;
            add(q / d, h);
            add(q / d, -h);
        }
    }
    return found;
}
