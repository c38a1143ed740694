// Polar.
//
// C, P and a point of contact are a triangle with a right angle there. So the point's foot on the line from
// C to P is r²/d away from C, and the point is r·h/d beside it, where h = √(d² − r²) is the length of the
// tangent.
import java.util.List;

class Solution {
    record Pt(double x, double y) {}

    static List<Pt> tangentPoints(double cx, double cy, double r, Pt P) {
        if (r == 0) return List.of(new Pt(cx, cy));
        double fx = P.x() - cx, fy = P.y() - cy, d = Math.hypot(fx, fy);
        double near = 1e-10 * Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));
        if (d < r - near) return List.of();
        if (d <= r + near) return List.of(P);

        double cosine = r / d, sine = Math.sqrt((d - r) * (d + r)) / d;   // of the angle at C
        double along = cosine * cosine, beside = cosine * sine;
        return List.of(
            new Pt(cx + along * fx + beside * fy, cy + along * fy - beside * fx),
            new Pt(cx + along * fx - beside * fy, cy + along * fy + beside * fx));
    }
}
