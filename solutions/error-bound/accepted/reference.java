// A running error bound.
//
// Each rounding is at most u = 2⁻⁵³ of its result: k is off by less than 4·u·M, with the sizes M of its two
// products, and r²·a by less than 8·u of itself. The constants are larger by half, for the bound is made of
// rounded numbers too.
class Solution {
    record Enclosure(double lo, double hi) {}

    static Enclosure deltaEnclosure(
            double cx, double cy, double r, double ax, double ay, double bx, double by) {
        final double u = 0x1p-53;
        double dx = bx - ax, dy = by - ay, fx = ax - cx, fy = ay - cy;
        double p = dx * fy, q = dy * fx, k = p - q, m = Math.abs(p) + Math.abs(q);
        double reach = r * r * (dx * dx + dy * dy), delta = reach - k * k;
        double bound = u * (12 * reach + 16 * m * Math.abs(k)) + 64 * u * u * m * m;
        if (bound == 0) return new Enclosure(0, 0);
        return new Enclosure(Math.nextDown(delta - bound), Math.nextUp(delta + bound));
    }
}
