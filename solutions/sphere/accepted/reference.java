// Foot and half-chord in space.
//
// The line is as far from the centre as the cross product of its unit vector and O − C is long; the rest is
// as in the plane. From the centre to the point is the normal, r long, and where the ray leaves it is
// turned round.
class Solution {
    record Pt3(double x, double y, double z) {
        double length() { return Math.sqrt(x * x + y * y + z * z); }
        Pt3 times(double s) { return new Pt3(x * s, y * s, z * s); }
        Pt3 plus(Pt3 v) { return new Pt3(x + v.x, y + v.y, z + v.z); }
        double dot(Pt3 v) { return x * v.x + y * v.y + z * v.z; }
        Pt3 cross(Pt3 v) { return new Pt3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x); }
    }
    record PairRealPt3(double first, Pt3 second) {}

    static PairRealPt3 raySphere(Pt3 C, double r, Pt3 O, Pt3 D) {
        double length = D.length();
        if (r == 0 || length == 0) return null;
        Pt3 u = D.times(1 / length), f = O.plus(C.times(-1));
        double near = 1e-10 * Math.max(Math.max(r, Math.abs(f.x)), Math.max(Math.abs(f.y), Math.abs(f.z)));

        double d = u.cross(f).length();
        if (d > r + near) return null;
        double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
        double foot = -u.dot(f);
        boolean enters = foot - half >= -near;
        double way = enters ? foot - half : foot + half;
        if (way < -near) return null;
        Pt3 normal = f.plus(u.times(way)).times((enters ? 1 : -1) / r);
        return new PairRealPt3(way > near ? way / length : 0, normal);
    }
}
