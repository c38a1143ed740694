// One loop over arrays of numbers.
//
// The direction and the length of the line are the same for all circles and are computed once. Each circle
// then takes a cross product and a comparison, within 1e-10 of its own size; the numbers lie side by
// side, and nothing is boxed.
class Solution {
    record Pt(double x, double y) {}

    static long[] countMany(double[] cx, double[] cy, double[] r, Pt A, Pt B) {
        double ax = A.x(), ay = A.y(), bx = B.x(), by = B.y();
        double dx = bx - ax, dy = by - ay, length = Math.hypot(dx, dy);
        long[] counts = new long[r.length];
        for (int i = 0; i < counts.length; i++) {
            double fx = ax - cx[i], fy = ay - cy[i];
            double gap = Math.abs(dx * fy - dy * fx) / length - r[i];
            double size = Math.max(r[i], Math.max(size(fx, fy), size(bx - cx[i], by - cy[i])));
            double near = 1e-10 * size;
            counts[i] = gap > near ? 0 : gap < -near ? 2 : 1;
        }
        return counts;
    }

    static double size(double x, double y) {
        return Math.max(Math.abs(x), Math.abs(y));
    }
}
