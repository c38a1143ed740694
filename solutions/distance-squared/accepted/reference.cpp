// Pythagoras in whole numbers.
//
// The ways along x and along y are the short sides of a right-angled triangle, and the distance is the long one. With
// coordinates up to 1e9 the sum of both squares is at most 8e18, which a long long still holds.

struct IntPt { long long x, y; };

long long distance_squared(IntPt P, IntPt Q) {
    long long dx = Q.x - P.x, dy = Q.y - P.y;
    return dx * dx + dy * dy;
}
