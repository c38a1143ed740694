// The fat wall.
//
// Let the disc be a point and the wall r thick: it has two straight sides and a round cap at each end. The way to the
// side that faces P0 is a quotient, the way to a cap that of a ray to a circle, and the first of them is the answer.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<double> time_of_impact(Pt P0, Pt P1, double r, Pt A, Pt B) {
    double size = r;
    for (Pt p : {P0, P1})
        for (Pt e : {A, B}) size = std::max({size, std::abs(p.x - e.x), std::abs(p.y - e.y)});
    double near = 1e-10 * size;

    double wx = B.x - A.x, wy = B.y - A.y, wall = std::hypot(wx, wy);
    double fx = P0.x - A.x, fy = P0.y - A.y, gx = P0.x - B.x, gy = P0.y - B.y;
    double height = wall > 0 ? (wx * fy - wy * fx) / wall : 0, foot = wall > 0 ? (wx * fx + wy * fy) / wall : 0;
    bool beside = 0 < foot && foot < wall;
    double away = beside ? std::abs(height) : std::min(std::hypot(fx, fy), std::hypot(gx, gy));
    if (away <= r + near) return 0;

    double dx = P1.x - P0.x, dy = P1.y - P0.y, way = std::hypot(dx, dy);
    if (way == 0) return {};
    double first = INFINITY;
    for (auto [x, y] : {Pt{fx, fy}, Pt{gx, gy}}) {
        double d = std::abs(dx * y - dy * x) / way;
        if (d > r + near) continue;
        double half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
        first = std::min(first, (-(dx * x + dy * y) / way - half) / way);
    }
    if (wall > 0 && wx * dy != wy * dx) {
        double rise = (wx * dy - wy * dx) / wall;  // of the height, from P0 to P1
        double t = ((height > 0 ? r : -r) - height) / rise;
        double place = foot + t * (dx * wx + dy * wy) / wall;
        if (0 <= place && place <= wall) first = std::min(first, t);
    }
    if (first < 0 || (first - 1) * way > near) return {};
    return first;
}
