// Fat wall.
//
// The disc becomes a point, and the wall grows by r: two sides, and a cap around each end. The distance
// from the wall's line changes evenly, each cap is a circle that a ray meets, and the first of all these
// moments is the answer.
class Solution {
    record Pt(double x, double y) {
        Pt minus(Pt v) { return new Pt(x - v.x, y - v.y); }
        double dot(Pt v) { return x * v.x + y * v.y; }
        double cross(Pt v) { return x * v.y - y * v.x; }
        double length() { return Math.hypot(x, y); }
        double size() { return Math.max(Math.abs(x), Math.abs(y)); }
    }

    static Double timeOfImpact(Pt P0, Pt P1, double r, Pt A, Pt B) {
        Pt D = P1.minus(P0), W = B.minus(A), f = P0.minus(A), g = P0.minus(B);
        double ends = Math.max(f.size(), g.size()), later = Math.max(P1.minus(A).size(), P1.minus(B).size());
        double near = 1e-10 * Math.max(r, Math.max(ends, later));

        double wall = W.length();
        double height = wall > 0 ? W.cross(f) / wall : 0, foot = wall > 0 ? W.dot(f) / wall : 0;
        boolean beside = 0 < foot && foot < wall;
        double start = beside ? Math.abs(height) : Math.min(f.length(), g.length());
        if (start <= r + near) return 0.0;
        double way = D.length();
        if (way == 0) return null;

        double t = Math.min(cap(f, D, way, r, near), cap(g, D, way, r, near));
        if (W.cross(D) != 0) {
            double side = (Math.copySign(r, height) - height) * wall / W.cross(D);
            double at = foot + side * W.dot(D) / wall;
            if (0 <= at && at <= wall) t = Math.min(t, side);
        }
        return t >= 0 && (t - 1) * way <= near ? t : null;
    }

    /** When f + t·D is first r away from the origin; infinity if never. */
    static double cap(Pt f, Pt D, double way, double r, double near) {
        double d = Math.abs(D.cross(f)) / way;
        if (d > r + near) return Double.POSITIVE_INFINITY;
        double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
        return (-D.dot(f) / way - half) / way;
    }
}
