// Pieces of the ray.
//
// The ends of all discs cut the ray into pieces, each of which is inside a disc or outside as a whole. The
// middle of a piece is asked of every disc, and the program then works on true and false. Ends that are
// nearly one are made one first.
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}
    record Circle(double x, double y, double r) {}
    record PairRealReal(double first, double second) {}

    static List<PairRealReal> insideSpans(List<Circle> circles, Pt O, Pt D, List<Long> program) {
        double size = 0;
        for (Circle c : circles) {
            double far = Math.max(Math.abs(c.x() - O.x()), Math.abs(c.y() - O.y()));
            size = Math.max(size, Math.max(c.r(), far));
        }
        double near = 1e-10 * size;
        double length = Math.hypot(D.x(), D.y()), ux = D.x() / length, uy = D.y() / length;

        int n = circles.size();
        double[] from = new double[n], to = new double[n], ends = new double[2 * n + 1];
        for (int i = 0; i < n; i++) {
            Circle c = circles.get(i);
            double fx = O.x() - c.x(), fy = O.y() - c.y(), r = c.r();
            double d = Math.abs(ux * fy - uy * fx), foot = -(ux * fx + uy * fy);
            if (d >= r - near) continue;   // what is only touched holds nothing
            double half = Math.sqrt((r - d) * (r + d));
            ends[2 * i] = from[i] = Math.max(0, foot - half);
            ends[2 * i + 1] = to[i] = Math.max(0, foot + half);
        }
        Arrays.sort(ends);

        var spans = new ArrayList<PairRealReal>();
        double start = 0, begun = -1;   // where the piece starts, and the span; -1 if there is none
        for (double end : ends) {
            if (end - start <= near) continue;
            boolean inside = holds(program, from, to, (start + end) / 2);
            if (inside && begun < 0) begun = start;
            if (!inside && begun >= 0) {
                spans.add(new PairRealReal(begun / length, start / length));
                begun = -1;
            }
            start = end;
        }
        if (begun >= 0) spans.add(new PairRealReal(begun / length, start / length));
        return spans;
    }

    static boolean holds(List<Long> program, double[] from, double[] to, double place) {
        boolean[] stack = new boolean[program.size()];
        int top = 0;
        for (long step : program) {
            if (step >= 0) {
                stack[top++] = from[(int) step] < place && place < to[(int) step];
                continue;
            }
            boolean upper = stack[--top], lower = stack[top - 1];
            stack[top - 1] = step == -1 ? lower || upper : step == -2 ? lower && upper : lower && !upper;
        }
        return stack[0];
    }
}
