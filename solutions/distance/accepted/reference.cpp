// Area by base.
//
// The cross product of B - A and P - A is the area of a parallelogram with the base |B - A|, and its height is the
// distance. P is subtracted before anything is multiplied, so that a figure far from the origin keeps its digits.

#include <cmath>
#include <optional>

struct Pt { double x, y; };

std::optional<double> distance(Pt A, Pt B, Pt P) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double area = dx * (P.y - A.y) - dy * (P.x - A.x);
    return std::abs(area) / std::hypot(dx, dy);
}
