// Half-open edges.
//
// Each edge has its first corner and not its last one, which is the first one of the next edge: so a corner
// is met once. Along an edge the crossings are half a chord before and after the foot, and nothing has to
// be sorted.
import java.util.ArrayList;
import java.util.List;

class Solution {
    record Pt(double x, double y) {}
    record PairIntPt(long first, Pt second) {}

    static List<PairIntPt> boundaryHits(double cx, double cy, double r, List<Pt> V) {
        double size = r;
        for (Pt corner : V) {
            double far = Math.max(Math.abs(corner.x() - cx), Math.abs(corner.y() - cy));
            size = Math.max(size, far);
        }
        double near = 1e-10 * size;

        var found = new ArrayList<PairIntPt>();
        for (int i = 0; i < V.size(); i++) {
            Pt A = V.get(i), B = V.get((i + 1) % V.size());
            double dx = B.x() - A.x(), dy = B.y() - A.y(), length = Math.hypot(dx, dy);
            double ux = dx / length, uy = dy / length;
            double fx = A.x() - cx, fy = A.y() - cy;
            double d = Math.abs(ux * fy - uy * fx);
            if (d > r + near) continue;
            double foot = -(ux * fx + uy * fy);
            double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
            for (double way : half > 0 ? new double[] {foot - half, foot + half} : new double[] {foot}) {
                if (-near <= way && way < length - near) {
                    found.add(new PairIntPt(i, new Pt(A.x() + way * ux, A.y() + way * uy)));
                }
            }
        }
        return found;
    }
}
