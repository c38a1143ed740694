// The right angle of Thales.
//
// P is on the circle exactly where it sees A and B at a right angle, which makes their scalar product 0.
// Inside the angle is wider and the product negative, outside it is positive; neither the centre nor a half
// is needed.
class Solution {
    record IntPt(long x, long y) {}

    static long diameterSide(IntPt A, IntPt B, IntPt P) {
        long ax = A.x() - P.x(), ay = A.y() - P.y();
        long bx = B.x() - P.x(), by = B.y() - P.y();
        return Long.signum(ax * bx + ay * by);
    }
}
