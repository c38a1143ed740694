// The cross product against the radius.
//
// The distance of C from the line is |k|/|D|, with D = B − A and the cross product k of D and C − A. It is
// compared with r after both were multiplied by |D| and squared, so that whole numbers stay whole.
class Solution {
    record IntPt(long x, long y) {}

    static long crossings(long cx, long cy, long r, IntPt A, IntPt B) {
        long dx = B.x() - A.x(), dy = B.y() - A.y();
        long k = dx * (cy - A.y()) - dy * (cx - A.x());
        return 1 + Long.signum(r * r * (dx * dx + dy * dy) - k * k);
    }
}
