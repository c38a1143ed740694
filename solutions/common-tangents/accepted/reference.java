// Normals.
//
// A tangent has a unit normal n, and the centres' distances from it are the radii: for v = C2 − C1 that is
// n·v = r1 − r2, or r1 + r2 if the tangent passes between the circles. Such an n is q/d along v and ±√(1 −
// q²/d²) beside it.
import java.util.ArrayList;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}

    static List<Pt> commonTangents(double cx1, double cy1, double r1, double cx2, double cy2, double r2) {
        double vx = cx2 - cx1, vy = cy2 - cy1, d = Math.hypot(vx, vy);
        double ux = vx / d, uy = vy / d;
        double near = 1e-10 * Math.max(Math.max(r1, r2), Math.max(Math.abs(vx), Math.abs(vy)));
        var found = new ArrayList<Pt>(4);
        for (double q : new double[] {r1 - r2, r1 + r2}) {
            double gap = d - Math.abs(q);
            if (gap < -near) continue;
            if (gap <= near) {
                double way = Math.copySign(r1, q);
                found.add(new Pt(cx1 + way * ux, cy1 + way * uy));
                continue;
            }
            double along = r1 * (q / d), beside = r1 * (Math.sqrt((d - q) * (d + q)) / d);
            found.add(new Pt(cx1 + along * ux - beside * uy, cy1 + along * uy + beside * ux));
            found.add(new Pt(cx1 + along * ux + beside * uy, cy1 + along * uy - beside * ux));
        }
        return found;
    }
}
