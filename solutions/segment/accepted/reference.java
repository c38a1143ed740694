// Foot and half-chord, between the ends.
//
// All places on the line are lengths counted from A: the foot of the perpendicular, half a chord before it
// and after it, and the end B. The points come from the foot as the centre sees it, so that they are exact
// even where A is far away.
import java.util.ArrayList;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}

    static List<Pt> circleSegment(double cx, double cy, double r, Pt A, Pt B) {
        double fx = A.x() - cx, fy = A.y() - cy;
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        double near = 1e-10 * Math.max(r, Math.max(size(fx, fy), size(B.x() - cx, B.y() - cy)));
        double length = Math.hypot(dx, dy);
        if (length == 0) return Math.abs(Math.hypot(fx, fy) - r) <= near ? List.of(A) : List.of();

        double ux = dx / length, uy = dy / length;
        double side = ux * fy - uy * fx;   // of the line from C, to the left
        double foot = -(ux * fx + uy * fy);
        double d = Math.abs(side);
        if (d > r + near) return List.of();
        double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;

        var found = new ArrayList<Pt>(2);
        for (double step : half > 0 ? new double[] {-half, half} : new double[] {0}) {
            if (-near <= foot + step && foot + step <= length + near) {
                found.add(new Pt(cx - side * uy + step * ux, cy + side * ux + step * uy));
            }
        }
        return found;
    }

    static double size(double x, double y) {
        return Math.max(Math.abs(x), Math.abs(y));
    }
}
