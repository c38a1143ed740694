// Angular sweep.
//
// Seen from O a circle covers an interval of angles, and the beams go through the sorted starts of these
// intervals once. Of the circles that have begun, the one whose nearest point is closest to O is asked
// first, until no other can be nearer.
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

class Solution {
    record IntPt(long x, long y) {}
    record IntCircle(long x, long y, long r) {}
    record PairIntReal(long first, double second) {}

    /** Circle `index` as seen from O: its angles, and how near it comes. */
    record Shape(double start, double end, double nearest, int index) {}

    static final double ROOM = 1e-6;   // radians around each interval, which only chooses whom to ask

    static List<PairIntReal> scan(List<IntCircle> circles, IntPt O, List<IntPt> dirs) {
        double largest = 0;
        var shapes = new ArrayList<Shape>();
        for (int i = 0; i < circles.size(); i++) {
            IntCircle c = circles.get(i);
            double fx = c.x() - O.x(), fy = c.y() - O.y(), away = Math.hypot(fx, fy);
            largest = Math.max(largest, Math.max(c.r(), Math.max(Math.abs(fx), Math.abs(fy))));
            double middle = Math.atan2(fy, fx), half = Math.asin(Math.min(1, c.r() / away)) + ROOM;
            for (double turn : new double[] {-2 * Math.PI, 0, 2 * Math.PI}) {
                double start = middle + turn - half, end = middle + turn + half;
                if (end >= -Math.PI && start <= Math.PI) shapes.add(new Shape(start, end, away - c.r(), i));
            }
        }
        shapes.sort(Comparator.comparingDouble(Shape::start));

        double near = 1e-10 * largest;
        var begun = new PriorityQueue<Shape>(Comparator.comparingDouble(Shape::nearest));
        var asked = new ArrayDeque<Shape>();
        var answers = new ArrayList<PairIntReal>(dirs.size());
        int next = 0;
        for (IntPt D : dirs) {
            double angle = Math.atan2(D.y(), D.x()), length = Math.hypot(D.x(), D.y());
            double ux = D.x() / length, uy = D.y() / length;
            while (next < shapes.size() && shapes.get(next).start() <= angle) begun.add(shapes.get(next++));
            double best = Double.POSITIVE_INFINITY;
            int found = -1;
            while (!begun.isEmpty() && begun.peek().nearest() <= best) {
                Shape shape = begun.poll();
                if (shape.end() < angle) continue;   // it has ended, and does not come back
                asked.add(shape);
                double way = firstHit(circles.get(shape.index()), O, ux, uy, near);
                if (way < best) {
                    best = way;
                    found = shape.index();
                }
            }
            begun.addAll(asked);
            asked.clear();
            answers.add(found < 0 ? null : new PairIntReal(found, best / length));
        }
        return answers;
    }

    static double firstHit(IntCircle c, IntPt O, double ux, double uy, double near) {
        double fx = c.x() - O.x(), fy = c.y() - O.y(), r = c.r();
        double d = Math.abs(ux * fy - uy * fx), foot = ux * fx + uy * fy;
        if (d > r + near || foot < 0) return Double.POSITIVE_INFINITY;
        return d < r - near ? foot - Math.sqrt((r - d) * (r + d)) : foot;
    }
}
