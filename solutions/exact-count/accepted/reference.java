// Sign of the discriminant in whole numbers.
//
// The distance of the line from C is |k|/|D|, with D = B − A and the cross product k. Compared with r,
// squared and multiplied by |D|², that is a subtraction of two BigIntegers, which lose no digit at any
// size.
import java.math.BigInteger;

class Solution {
    record IntPt(BigInteger x, BigInteger y) {}

    static Integer exactCount(BigInteger cx, BigInteger cy, BigInteger r, IntPt A, IntPt B) {
        BigInteger dx = B.x().subtract(A.x()), dy = B.y().subtract(A.y());
        BigInteger square = dx.multiply(dx).add(dy.multiply(dy));
        if (square.signum() == 0) return null;
        BigInteger fx = A.x().subtract(cx), fy = A.y().subtract(cy);
        BigInteger k = dx.multiply(fy).subtract(dy.multiply(fx));
        return 1 + r.multiply(r).multiply(square).compareTo(k.multiply(k));
    }
}
