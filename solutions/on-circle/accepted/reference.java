// Distance against radius.
//
// Seen from the centre, so that a small circle far from the origin keeps its digits, |P − C| is compared
// with r. The threshold is 1e-10 of the extent: it lies in the gap that the statement promises, whatever
// the size of the figure.
class Solution {
    record Pt(double x, double y) {}

    static long onCircle(double cx, double cy, double r, Pt P) {
        double fx = P.x() - cx, fy = P.y() - cy;
        double extent = Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));
        double gap = Math.hypot(fx, fy) - r;
        if (Math.abs(gap) <= 1e-10 * extent) return 0;
        return gap > 0 ? 1 : -1;
    }
}
