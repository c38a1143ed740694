// Distance from the cross product.
//
// Seen from the centre, the cross product of B − A and A − C is |B − A| times the distance of the line, and
// is known wherever A and B are on it. The distance is compared with r within 1e-10 of the size, which is
// more than rounding and less than what is promised.
class Solution {
    record Pt(double x, double y) {}

    static Long lineCount(double cx, double cy, double r, Pt A, Pt B) {
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double fx = A.x() - cx, fy = A.y() - cy;
        double largest = Math.max(r, Math.max(size(fx, fy), size(B.x() - cx, B.y() - cy)));
        double gap = Math.abs(dx * fy - dy * fx) / Math.hypot(dx, dy) - r;
        if (Math.abs(gap) <= 1e-10 * largest) return 1L;
        return gap < 0 ? 2L : 0L;
    }

    static double size(double x, double y) {
        return Math.max(Math.abs(x), Math.abs(y));
    }
}
