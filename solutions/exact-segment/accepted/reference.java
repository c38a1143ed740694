// Four signs.
//
// Whether A is inside, whether B is, whether the line meets the circle, and whether the foot of the
// perpendicular is on the segment: these decide all. Each is the sign of a BigInteger, and nothing is
// divided.
import java.math.BigInteger;

class Solution {
    record IntPt(BigInteger x, BigInteger y) {
        IntPt minus(BigInteger px, BigInteger py) { return new IntPt(x.subtract(px), y.subtract(py)); }
        BigInteger dot(IntPt v) { return x.multiply(v.x).add(y.multiply(v.y)); }
        BigInteger cross(IntPt v) { return x.multiply(v.y).subtract(y.multiply(v.x)); }
    }

    static int exactSegment(BigInteger cx, BigInteger cy, BigInteger r, IntPt A, IntPt B) {
        IntPt f = A.minus(cx, cy), g = B.minus(cx, cy), d = g.minus(f.x(), f.y());
        BigInteger rr = r.multiply(r), dd = d.dot(d);
        // -1 inside, 0 on the circle, 1 outside
        int sideOfA = f.dot(f).compareTo(rr), sideOfB = g.dot(g).compareTo(rr);
        if (dd.signum() == 0) return sideOfA == 0 ? 1 : 0;

        BigInteger k = d.cross(f), way = f.dot(d).negate();   // from A to the foot, as a multiple of d/dd
        int meets = rr.multiply(dd).compareTo(k.multiply(k));
        if (meets < 0) return 0;
        boolean footBetween = way.signum() >= 0 && way.compareTo(dd) <= 0;
        if (meets == 0) return footBetween ? 1 : 0;
        if (sideOfA < 0 || sideOfB < 0) return (sideOfA >= 0 ? 1 : 0) + (sideOfB >= 0 ? 1 : 0);
        if (footBetween) return 2;
        return (sideOfA == 0 ? 1 : 0) + (sideOfB == 0 ? 1 : 0);
    }
}
