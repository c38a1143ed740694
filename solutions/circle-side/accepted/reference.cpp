// Squares instead of the root.
//
// P is as far from the centre as the root of dx² + dy². Two numbers that are not negative compare as their squares
// do, and the squares are whole numbers that a long long holds.

struct IntPt { long long x, y; };

long long circle_side(long long cx, long long cy, long long r, IntPt P) {
    long long dx = P.x - cx, dy = P.y - cy;
    long long square = dx * dx + dy * dy;
    return (square > r * r) - (square < r * r);
}
