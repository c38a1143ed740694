// The direction turned by a quarter.
//
// (−dy, dx) is B − A turned to the left; made one long it is (a, b), whose product with a vector is how far
// that vector goes to the left. Counted from A that is the signed distance, which leaves c = −(a·Ax +
// b·Ay).
class Solution {
    record Pt(double x, double y) {}
    record Pt3(double x, double y, double z) {}

    static Pt3 normalForm(Pt A, Pt B) {
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double length = Math.hypot(dx, dy);
        double a = -dy / length, b = dx / length;
        return new Pt3(a, b, -(a * A.x() + b * A.y()));
    }
}
