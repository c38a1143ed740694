// Projection by scalar products.
//
// With D = B − A the projection of C − A onto the line is t = (C − A)·D / D·D, in lengths of D, and the
// foot is A + t·D. Neither a root nor an angle is needed, and an upright line is like any other.
class Solution {
    record Pt(double x, double y) {}
    record PairRealPt(double first, Pt second) {}

    static PairRealPt foot(Pt A, Pt B, Pt C) {
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double t = ((C.x() - A.x()) * dx + (C.y() - A.y()) * dy) / (dx * dx + dy * dy);
        return new PairRealPt(t, new Pt(A.x() + t * dx, A.y() + t * dy));
    }
}
