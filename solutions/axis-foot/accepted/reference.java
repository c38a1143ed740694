// One coordinate from each.
//
// The foot on a level line has P's x and the line's y, and on an upright line it is the other way round.
// Nothing has to be computed.
class Solution {
    record IntPt(long x, long y) {}

    static IntPt axisFoot(IntPt A, IntPt B, IntPt P) {
        boolean level = A.y() == B.y();
        return level ? new IntPt(P.x(), A.y()) : new IntPt(A.x(), P.y());
    }
}
