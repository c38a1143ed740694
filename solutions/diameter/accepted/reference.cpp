// The angle at P, by Thales.
//
// Seen from a point on the circle the ends of a diameter make a right angle, from inside a wider one and from outside
// a narrower one. The scalar product of the arrows from P to A and to B has the sign that tells, without centre or
// radius.

struct IntPt { long long x, y; };

long long diameter_side(IntPt A, IntPt B, IntPt P) {
    long long dot = (A.x - P.x) * (B.x - P.x) + (A.y - P.y) * (B.y - P.y);
    return (dot > 0) - (dot < 0);
}
