// One bit of memory.
//
// What the last frame showed says which of the two thresholds counts now. A threshold is passed only by
// more than 1e-10 of the frame's size, so that rounding never passes one.
import java.util.ArrayList;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}
    record Circle(double x, double y, double r) {}

    static List<Long> steadyHits(List<Circle> circles, Pt O, Pt D, double h) {
        double length = Math.hypot(D.x(), D.y()), ux = D.x() / length, uy = D.y() / length;
        var frames = new ArrayList<Long>();
        boolean shown = false;
        for (Circle c : circles) {
            double fx = O.x() - c.x(), fy = O.y() - c.y(), r = c.r();
            double d = Math.abs(ux * fy - uy * fx);
            double near = 1e-10 * Math.max(r, Math.max(Math.abs(fx), Math.abs(fy)));
            if (frames.isEmpty()) shown = d < r;
            else if (shown) shown = d <= r * (1 + h) + near;
            else shown = d < r * (1 - h) - near;
            frames.add(shown ? 1L : 0L);
        }
        return frames;
    }
}
