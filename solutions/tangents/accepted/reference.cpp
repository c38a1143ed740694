// The polar of P.
//
// C, P and a point of contact make a triangle with a right angle at the contact and the long side d = |P - C|. So the
// contact is r²/d from C along the way to P, and r·h/d beside it, where h = √(d² - r²) is the tangent's length.

#include <algorithm>
#include <cmath>
#include <vector>

struct Pt { double x, y; };

std::vector<Pt> tangent_points(double cx, double cy, double r, Pt P) {
    if (r == 0) return {{cx, cy}};
    double fx = P.x - cx, fy = P.y - cy, d = std::hypot(fx, fy);
    double near = 1e-10 * std::max({r, std::abs(fx), std::abs(fy)});
    if (d < r - near) return {};
    if (d <= r + near) return {P};
    double h = std::sqrt((d - r) * (d + r));
    double along = r / d * (r / d), beside = r / d * (h / d);
    return {{cx + along * fx + beside * fy, cy + along * fy - beside * fx},
            {cx + along * fx - beside * fy, cy + along * fy + beside * fx}};
}
