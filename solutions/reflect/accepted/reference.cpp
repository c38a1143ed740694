// The part along the normal turns round.
//
// D has a part along the normal N and one across it. The first is (D·N)N, and taken away twice it is turned round; N
// goes in twice, so that it may point to either side. D need not have the length 1, but N must.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };
struct PairPtPt { Pt first, second; };

std::optional<PairPtPt> reflect(double cx, double cy, double r, Pt O, Pt D) {
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
        double twice = 2 * (D.x * nx + D.y * ny);
        return PairPtPt{{O.x + way * ux, O.y + way * uy}, {D.x - twice * nx, D.y - twice * ny}};
    }
    return {};
}
