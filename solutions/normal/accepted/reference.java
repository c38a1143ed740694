// The hit from the centre.
//
// The point of the hit as seen from C is r long: divided by r it is the normal that points outward. If the
// first of the two points on the line is behind O, the ray leaves at the second one, and the normal is
// turned round.
class Solution {
    record Pt(double x, double y) {}

    static Pt hitNormal(double cx, double cy, double r, Pt O, Pt D) {
        double length = Math.hypot(D.x(), D.y());
        if (r == 0 || length == 0) return null;
        double ux = D.x() / length, uy = D.y() / length;
        double fx = O.x() - cx, fy = O.y() - cy;
        double near = 1e-10 * Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));

        double d = Math.abs(ux * fy - uy * fx);
        if (d > r + near) return null;
        double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
        double foot = -(ux * fx + uy * fy);
        boolean enters = foot - half >= -near;
        double way = enters ? foot - half : foot + half;
        if (way < -near) return null;
        double scale = (enters ? 1 : -1) / r;
        return new Pt((fx + way * ux) * scale, (fy + way * uy) * scale);
    }
}
