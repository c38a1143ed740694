// Sort them all.
//
// Each circle gives two hits, one touch or none: half a chord before the foot of the perpendicular the ray
// enters, and half a chord after it it leaves. The tag goes with the hit before all of them are sorted by
// t.
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}
    record Circle(double x, double y, double r) {}
    record TripleRealIntWord(double first, long second, String third) {}

    static List<TripleRealIntWord> allHits(List<Circle> circles, Pt O, Pt D) {
        double size = 0;
        for (Circle c : circles) {
            double far = Math.max(Math.abs(c.x() - O.x()), Math.abs(c.y() - O.y()));
            size = Math.max(size, Math.max(c.r(), far));
        }
        double near = 1e-10 * size;
        double length = Math.hypot(D.x(), D.y()), ux = D.x() / length, uy = D.y() / length;

        var hits = new ArrayList<TripleRealIntWord>();
        for (int i = 0; i < circles.size(); i++) {
            Circle c = circles.get(i);
            double fx = O.x() - c.x(), fy = O.y() - c.y(), r = c.r();
            double d = Math.abs(ux * fy - uy * fx), foot = -(ux * fx + uy * fy);
            if (d > r + near) continue;
            if (d >= r - near) {
                if (foot >= -near) hits.add(new TripleRealIntWord(Math.max(foot, 0) / length, i, "touch"));
                continue;
            }
            double half = Math.sqrt((r - d) * (r + d)), enter = foot - half, exit = foot + half;
            if (enter >= -near) hits.add(new TripleRealIntWord(Math.max(enter, 0) / length, i, "enter"));
            if (exit >= -near) hits.add(new TripleRealIntWord(Math.max(exit, 0) / length, i, "exit"));
        }
        hits.sort(Comparator.comparingDouble(TripleRealIntWord::first));
        return hits;
    }
}
