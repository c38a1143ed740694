// Projection by scalar products.
//
// f·D is |D| times the length of the projection of f = C - A on D = B - A, and D·D is |D|²: their quotient is the
// parameter t of the foot. Neither a root nor a slope is needed, so an upright line is like any other.

#include <optional>

struct Pt { double x, y; };
struct PairRealPt { double first; Pt second; };

std::optional<PairRealPt> foot(Pt A, Pt B, Pt C) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return {};
    double t = ((C.x - A.x) * dx + (C.y - A.y) * dy) / (dx * dx + dy * dy);
    return PairRealPt{t, {A.x + t * dx, A.y + t * dy}};
}
