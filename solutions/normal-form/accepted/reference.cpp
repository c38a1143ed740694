// The direction turned to the left.
//
// (-Dy, Dx) is D turned by a quarter to the left. Divided by its length its product with a point is how far that
// point is to the left, but for a constant, which A makes 0.

#include <cmath>
#include <optional>

struct Pt { double x, y; };
struct Pt3 { double x, y, z; };

std::optional<Pt3> normal_form(Pt A, Pt B) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double length = std::hypot(dx, dy);
    double a = -dy / length, b = dx / length;
    return Pt3{a, b, -(a * A.x + b * A.y)};
}
