// Foot and half-chord.
//
// The foot of the perpendicular is the middle of both points, and from there it is half a chord back and
// forth along the line. The foot is seen from the centre, by the cross product, so that it may be far from
// A.
import java.util.List;

class Solution {
    record Pt(double x, double y) {}

    static List<Pt> linePoints(double cx, double cy, double r, Pt A, Pt B) {
        double dx = B.x() - A.x(), dy = B.y() - A.y();
        if (dx == 0 && dy == 0) return null;
        double fx = A.x() - cx, fy = A.y() - cy;
        double near = 1e-10 * Math.max(r, Math.max(size(fx, fy), size(B.x() - cx, B.y() - cy)));
        double length = Math.hypot(dx, dy), ux = dx / length, uy = dy / length;
        double side = ux * fy - uy * fx;   // of the line from C, to the left
        double footX = cx - side * uy, footY = cy + side * ux;

        double d = Math.abs(side);
        if (d > r + near) return List.of();
        if (d >= r - near) return List.of(new Pt(footX, footY));
        double half = Math.sqrt((r - d) * (r + d));
        return List.of(
            new Pt(footX - half * ux, footY - half * uy),
            new Pt(footX + half * ux, footY + half * uy));
    }

    static double size(double x, double y) {
        return Math.max(Math.abs(x), Math.abs(y));
    }
}
