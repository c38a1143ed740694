// Twice the normal part.
//
// (D·N)N is the part of D along the normal: taken away once, the ray would slide along the circle, and
// taken away twice, it is reflected. N goes in twice, so that inside is no other case than outside; but it
// must be one long.
class Solution {
    record Pt(double x, double y) {}
    record PairPtPt(Pt first, Pt second) {}

    static PairPtPt reflect(double cx, double cy, double r, Pt O, Pt D) {
        double length = Math.hypot(D.x(), D.y());
        if (r == 0 || length == 0) return null;
        double ux = D.x() / length, uy = D.y() / length;
        double fx = O.x() - cx, fy = O.y() - cy;
        double near = 1e-10 * Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));

        double d = Math.abs(ux * fy - uy * fx);
        if (d > r + near) return null;
        double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
        double foot = -(ux * fx + uy * fy);
        double way = foot - half >= -near ? foot - half : foot + half;
        if (way < -near) return null;

        double nx = (fx + way * ux) / r, ny = (fy + way * uy) / r;
        double twice = 2 * (D.x() * nx + D.y() * ny);
        return new PairPtPt(
            new Pt(O.x() + way * ux, O.y() + way * uy),
            new Pt(D.x() - twice * nx, D.y() - twice * ny));
    }
}
