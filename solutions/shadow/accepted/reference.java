// Two rays.
//
// The first ray takes the least root ahead of it. The second one goes from the point to the light, and is
// stopped by any root between 1e-9 of the size, so that the point is not in its own shadow, and the
// light.
import java.util.List;

class Solution {
    record Pt(double x, double y) {}
    record Circle(double x, double y, double r) {}

    static String light(List<Circle> circles, Pt O, Pt D, Pt L) {
        double size = Math.max(Math.abs(L.x() - O.x()), Math.abs(L.y() - O.y()));
        for (Circle c : circles) {
            double far = Math.max(Math.abs(c.x() - O.x()), Math.abs(c.y() - O.y()));
            size = Math.max(size, Math.max(c.r(), far));
        }
        double length = Math.hypot(D.x(), D.y()), ux = D.x() / length, uy = D.y() / length;
        double way = Double.POSITIVE_INFINITY;
        Circle hit = null;
        for (Circle c : circles) {
            double s = firstBeyond(0, O.x() - c.x(), O.y() - c.y(), c.r(), ux, uy);
            if (s < way) {
                way = s;
                hit = c;
            }
        }
        if (hit == null) return null;

        // Seen from the centre of the circle that is hit: the point, and the way from there to the light.
        double px = O.x() - hit.x() + way * ux, py = O.y() - hit.y() + way * uy;
        double vx = L.x() - hit.x() - px, vy = L.y() - hit.y() - py, reach = Math.hypot(vx, vy);
        boolean fromOutside = ux * px + uy * py < 0, lightOutside = vx * px + vy * py > 0;
        if (fromOutside != lightOutside) return "dark";
        for (Circle c : circles) {
            double fx = px + (hit.x() - c.x()), fy = py + (hit.y() - c.y());
            if (firstBeyond(1e-9 * size, fx, fy, c.r(), vx / reach, vy / reach) < reach) return "dark";
        }
        return "lit";
    }

    /** How far along u the circle's first point beyond `start` is, f being the ray's origin seen from C. */
    static double firstBeyond(double start, double fx, double fy, double r, double ux, double uy) {
        double d = Math.abs(ux * fy - uy * fx), foot = -(ux * fx + uy * fy);
        if (d >= r) return Double.POSITIVE_INFINITY;
        double half = Math.sqrt((r - d) * (r + d));
        if (foot - half > start) return foot - half;
        return foot + half > start ? foot + half : Double.POSITIVE_INFINITY;
    }
}
