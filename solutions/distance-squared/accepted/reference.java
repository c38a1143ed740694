// The theorem of Pythagoras.
//
// The way along x and the way along y are the legs of a right-angled triangle, and the distance is its long
// side. Each leg is at most 2·10⁹, so that the sum of their squares fits into a long.
class Solution {
    record IntPt(long x, long y) {}

    static long distanceSquared(IntPt P, IntPt Q) {
        long dx = Q.x() - P.x(), dy = Q.y() - P.y();
        return dx * dx + dy * dy;
    }
}
