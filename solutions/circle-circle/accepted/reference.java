// Radical line.
//
// The difference of the two equations is a line at right angles to C1→C2, at a = (d² + r1² − r2²)/2d from
// C1, and it cuts the first circle where the second one does. Touches and one centre are told apart before
// that, by lengths.
import java.util.List;

class Solution {
    record Pt(double x, double y) {}

    static List<Pt> circleCircle(double cx1, double cy1, double r1, double cx2, double cy2, double r2) {
        double vx = cx2 - cx1, vy = cy2 - cy1, d = Math.hypot(vx, vy);
        double sum = r1 + r2, difference = Math.abs(r1 - r2);
        double near = 1e-10 * Math.max(Math.max(r1, r2), Math.max(Math.abs(vx), Math.abs(vy)));
        if (d <= near) {
            if (r1 == 0 && r2 == 0) return List.of(new Pt(cx1, cy1));
            return difference <= near ? null : List.of();
        }
        if (d > sum + near || d < difference - near) return List.of();

        double ux = vx / d, uy = vy / d;
        if (d >= sum - near) return List.of(new Pt(cx1 + r1 * ux, cy1 + r1 * uy));
        if (d <= difference + near) {
            double way = r1 > r2 ? r1 : -r1;
            return List.of(new Pt(cx1 + way * ux, cy1 + way * uy));
        }
        double a = (d + (r1 - r2) * (sum / d)) / 2;
        double h = Math.sqrt(Math.max(0, (r1 - a) * (r1 + a)));
        double x = cx1 + a * ux, y = cy1 + a * uy;
        return List.of(new Pt(x - h * uy, y + h * ux), new Pt(x + h * uy, y - h * ux));
    }
}
