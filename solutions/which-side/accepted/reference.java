// The sign of the cross product.
//
// The cross product of B − A and P − A is twice the area of the triangle A, B, P, and its sign says which
// way round they go. Each of the two products is at most 4·10¹⁸, so that even their difference fits into a
// long.
class Solution {
    record IntPt(long x, long y) {}

    static long whichSide(IntPt A, IntPt B, IntPt P) {
        long dx = B.x() - A.x(), dy = B.y() - A.y();
        long fx = P.x() - A.x(), fy = P.y() - A.y();
        return Long.signum(dx * fy - dy * fx);
    }
}
