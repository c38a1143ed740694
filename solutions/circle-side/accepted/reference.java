// Squares instead of roots.
//
// Two lengths compare as their squares do, and the squares are whole: dx² + dy² against r². They stay below
// 9·10¹⁸, so that a long holds them exactly.
class Solution {
    record IntPt(long x, long y) {}

    static long circleSide(long cx, long cy, long r, IntPt P) {
        long dx = P.x() - cx, dy = P.y() - cy;
        return Long.signum(dx * dx + dy * dy - r * r);
    }
}
