// Distance against radius.
//
// Seen from the centre, so that a small circle far from the origin keeps its digits, |P − C| is compared
// with r. The threshold is 1e-10 of the size, which lies between rounding and the nearest miss.
class Solution {
    record Pt(double x, double y) {}

    static long onCircle(double cx, double cy, double r, Pt P) {
        double fx = P.x() - cx, fy = P.y() - cy;
        double size = Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));
        double gap = Math.hypot(fx, fy) - r;
        if (Math.abs(gap) <= 1e-10 * size) return 0;
        return gap > 0 ? 1 : -1;
    }
}
