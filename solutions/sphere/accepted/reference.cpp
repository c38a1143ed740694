// Foot and half-chord in space.
//
// The line's distance from the centre is the length of the cross product of u and O - C, and the foot is -(u·f) along
// the ray: the rest is as in the plane. From the centre to the point is the normal, r long; where the ray leaves it
// is turned round, and which of both points it is says so.

#include <algorithm>
#include <cmath>
#include <optional>

struct Pt3 { double x, y, z; };
struct PairRealPt3 { double first; Pt3 second; };

std::optional<PairRealPt3> ray_sphere(Pt3 C, double r, Pt3 O, Pt3 D) {
    double length = std::hypot(D.x, D.y, D.z);
    if (length == 0 || r == 0) return {};
    Pt3 u = {D.x / length, D.y / length, D.z / length}, f = {O.x - C.x, O.y - C.y, O.z - C.z};
    double near = 1e-10 * std::max({r, std::abs(f.x), std::abs(f.y), std::abs(f.z)});
    double d = std::hypot(u.y * f.z - u.z * f.y, u.z * f.x - u.x * f.z, u.x * f.y - u.y * f.x);
    if (d > r + near) return {};
    double foot = -(u.x * f.x + u.y * f.y + u.z * f.z);
    double half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
    for (int side : {1, -1}) {
        double way = foot - side * half;
        if (way < -near) continue;
        Pt3 normal = {side * (f.x + way * u.x) / r, side * (f.y + way * u.y) / r, side * (f.z + way * u.z) / r};
        return PairRealPt3{way > near ? way / length : 0, normal};
    }
    return {};
}
