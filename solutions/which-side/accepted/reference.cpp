// The sign of a cross product.
//
// The cross product of B - A and P - A is twice the area of the triangle A, B, P, and above 0 where P is to the left.
// It stays below 8e18 here, so that long long holds it exactly; a double would round it.

struct IntPt { long long x, y; };

long long which_side(IntPt A, IntPt B, IntPt P) {
    long long cross = (B.x - A.x) * (P.y - A.y) - (B.y - A.y) * (P.x - A.x);
    return (cross > 0) - (cross < 0);
}
