// Relative motion.
//
// Seen from the second disc, which then rests, the first one moves along D, the difference of both ways.
// With r + s as the radius of the one and a point for the other, it is the question where a ray meets a
// circle.
class Solution {
    record Pt(double x, double y) {
        Pt minus(Pt v) { return new Pt(x - v.x, y - v.y); }
        double length() { return Math.hypot(x, y); }
        double size() { return Math.max(Math.abs(x), Math.abs(y)); }
    }

    static Double ballsMeet(Pt P0, Pt P1, double r, Pt Q0, Pt Q1, double s) {
        double reach = r + s;
        Pt f = P0.minus(Q0), D = P1.minus(P0).minus(Q1.minus(Q0));
        double ways = Math.max(f.size(), Math.max(P1.minus(P0).size(), Q1.minus(P0).size()));
        double near = 1e-10 * Math.max(reach, ways);
        if (f.length() <= reach + near) return 0.0;

        double length = D.length();
        if (length == 0) return null;
        double d = Math.abs(D.x * f.y - D.y * f.x) / length;
        if (d > reach + near) return null;
        double half = d < reach - near ? Math.sqrt((reach - d) * (reach + d)) : 0;
        double way = -(D.x * f.x + D.y * f.y) / length - half;
        return 0 <= way && way <= length + near ? way / length : null;
    }
}
