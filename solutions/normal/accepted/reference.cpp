// The hit as seen from the centre.
//
// The point of the hit less C is r long, so divided by r it is the normal that points outward; C is never added,
// which would cost digits far from the origin. Where the ray leaves the circle the normal is turned round, towards
// the ray.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<Pt> hit_normal(double cx, double cy, double r, Pt O, Pt D) {
    double length = std::hypot(D.x, D.y);
    if (r == 0 || length == 0) return {};
    double ux = D.x / length, uy = D.y / length, fx = O.x - cx, fy = O.y - cy;
    double near = 1e-10 * std::max({r, std::abs(fx), std::abs(fy)});
    double d = std::abs(D.x * fy - D.y * fx) / length;
    if (d > r + near) return {};
    double foot = -(ux * fx + uy * fy);
    double half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
    for (double way : {foot - half, foot + half}) {
        if (way < -near) continue;
        double nx = (fx + way * ux) / r, ny = (fy + way * uy) / r;
        bool leaves = half > 0 && nx * ux + ny * uy > 0;
        return leaves ? Pt{-nx, -ny} : Pt{nx, ny};
    }
    return {};
}
