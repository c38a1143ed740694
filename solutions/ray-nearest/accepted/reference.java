// The quadratic without cancellation.
//
// Whether the ray meets the circle is decided by lengths, |k|/|D| against r. Of the two roots q/a adds
// numbers of one sign, and the other one is c/q, because their product is c/a: so neither subtracts what is
// nearly equal.
class Solution {
    record Pt(double x, double y) {}

    static Double rayNearest(double cx, double cy, double r, Pt O, Pt D) {
        double a = D.x() * D.x() + D.y() * D.y();
        if (a == 0) return null;
        double fx = O.x() - cx, fy = O.y() - cy;
        double near = 1e-10 * Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));
        double b = fx * D.x() + fy * D.y(), c = fx * fx + fy * fy - r * r;
        double k = D.x() * fy - D.y() * fx;   // b² − a·c = r²a − k²
        double length = Math.sqrt(a), gap = Math.abs(k) / length - r;
        if (gap > near) return null;

        double first = -b / a, second = first;
        if (gap < -near) {
            double q = -(b + Math.copySign(Math.sqrt(r * r * a - k * k), b));
            first = Math.min(q / a, c / q);
            second = Math.max(q / a, c / q);
        }
        double slack = near / length;
        if (Math.abs(first) <= slack || Math.abs(second) <= slack && first < 0) return 0.0;
        if (first > 0) return first;
        return second > 0 ? second : null;
    }
}
