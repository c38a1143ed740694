// A filter before exact arithmetic.
//
// Δ in doubles comes with a bound of all its roundings, and outside of it the sign is sure. Only the few
// lines within it are decided by BigDecimals, which hold every double, and every sum and product of them,
// without an error.
import java.math.BigDecimal;

class Solution {
    static long deltaSign(double cx, double cy, double r, double ax, double ay, double bx, double by) {
        double dx = bx - ax, dy = by - ay, fx = ax - cx, fy = ay - cy;
        double p = dx * fy, q = dy * fx, k = p - q, m = Math.abs(p) + Math.abs(q);
        double reach = r * r * (dx * dx + dy * dy), delta = reach - k * k;
        double bound = 2e-15 * (reach + m * Math.abs(k)) + 2e-30 * m * m;
        if (Math.abs(delta) > bound) return delta > 0 ? 1 : -1;
        return exactly(cx, cy, r, ax, ay, bx, by);
    }

    static int exactly(double cx, double cy, double r, double ax, double ay, double bx, double by) {
        BigDecimal dx = difference(bx, ax), dy = difference(by, ay);
        BigDecimal fx = difference(ax, cx), fy = difference(ay, cy);
        BigDecimal k = dx.multiply(fy).subtract(dy.multiply(fx));
        BigDecimal reach = new BigDecimal(r).pow(2).multiply(dx.pow(2).add(dy.pow(2)));
        return reach.compareTo(k.pow(2));
    }

    static BigDecimal difference(double x, double y) {
        return new BigDecimal(x).subtract(new BigDecimal(y));
    }
}
