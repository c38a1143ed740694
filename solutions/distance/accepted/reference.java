// Area by base.
//
// The cross product of B − A and A − P is the area of a parallelogram that has |B − A| as its base and the
// distance as its height. P is subtracted before anything is multiplied, and the only division comes last.
class Solution {
    record Pt(double x, double y) {}

    static Double distance(Pt A, Pt B, Pt P) {
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double fx = A.x() - P.x(), fy = A.y() - P.y();
        return Math.abs(dx * fy - dy * fx) / Math.hypot(dx, dy);
    }
}
