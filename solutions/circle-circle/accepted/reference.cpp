// The radical line.
//
// The difference of both circles' equations is a line at right angles to C1C2, and it cuts the first circle where the
// second one does. One centre, a touch and a miss are told apart before, by lengths and within 1e-10 extents.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

struct Pt { double x, y; };

std::optional<std::vector<Pt>> circle_circle(double cx1, double cy1, double r1, double cx2, double cy2, double r2) {
    using Points = std::vector<Pt>;
    double vx = cx2 - cx1, vy = cy2 - cy1, d = std::hypot(vx, vy);
    double near = 1e-10 * std::max({r1, r2, std::abs(vx), std::abs(vy)});
    if (d <= near) {
        if (r1 == 0 && r2 == 0) return Points{{cx1, cy1}};
        if (std::abs(r1 - r2) <= near) return {};
        return Points{};
    }
    double ux = vx / d, uy = vy / d, outer = r1 + r2, inner = std::abs(r1 - r2);
    if (std::abs(d - outer) <= near) return Points{{cx1 + r1 * ux, cy1 + r1 * uy}};
    if (std::abs(d - inner) <= near) {
        double way = r1 > r2 ? r1 : -r1;
        return Points{{cx1 + way * ux, cy1 + way * uy}};
    }
    if (d > outer || d < inner) return Points{};
    double a = (d + (r1 - r2) * (outer / d)) / 2;
    double h = std::sqrt(std::max(0.0, (r1 - a) * (r1 + a)));
    return Points{{cx1 + a * ux - h * uy, cy1 + a * uy + h * ux}, {cx1 + a * ux + h * uy, cy1 + a * uy - h * ux}};
}
