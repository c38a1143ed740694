// Half-chord.
//
// The centre, the foot of the perpendicular and an end of the chord are a right-angled triangle: half of
// the chord is √((r − d)(r + d)), with the distance d of the line. Whether the line touches is decided by
// lengths, before any root.
class Solution {
    record Pt(double x, double y) {}

    static Double chordLength(double cx, double cy, double r, Pt A, Pt B) {
        double fx = A.x() - cx, fy = A.y() - cy;
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double near = 1e-10 * Math.max(r, Math.max(size(fx, fy), size(B.x() - cx, B.y() - cy)));
        double d = Math.abs(dx * fy - dy * fx) / Math.hypot(dx, dy);
        if (d > r + near) return null;
        if (d >= r - near) return 0.0;
        return 2 * Math.sqrt((r - d) * (r + d));
    }

    static double size(double x, double y) {
        return Math.max(Math.abs(x), Math.abs(y));
    }
}
