// kld-intersections 0.7.0: Intersection.intersectCircleLine
//
// Its line is a segment. The discriminant is compared with 0, and t with 0 and 1, without any room.

const { Intersection, Point2D } = require('kld-intersections');

function circleSegment(cx, cy, r, A, B) {
  const known = atAPoint(cx, cy, r, A, B);
  if (known) return known;
  const [C, from, to] = [[cx, cy], [A.x, A.y], [B.x, B.y]].map((p) => new Point2D(...p));
  const found = Intersection.intersectCircleLine(C, r, from, to).points;
  const far = (p) => Math.hypot(p.x - A.x, p.y - A.y);
  return found.map((p) => ({ x: p.x, y: p.y })).sort((p, q) => far(p) - far(q));
}

// The answer where the circle or the segment is one point; undefined where neither is.
function atAPoint(cx, cy, r, A, B) {
  if (A.x === B.x && A.y === B.y) {
    const far = Math.hypot(A.x - cx, A.y - cy);
    return Math.abs(far - r) <= 1e-9 * Math.max(far, r) ? [A] : [];
  }
  if (r > 0) return undefined;
  const ux = B.x - A.x, uy = B.y - A.y, t = ((cx - A.x) * ux + (cy - A.y) * uy) / (ux * ux + uy * uy);
  const off = Math.hypot(cx - A.x - t * ux, cy - A.y - t * uy);
  return 0 <= t && t <= 1 && off <= 1e-9 * Math.hypot(ux, uy) ? [{ x: cx, y: cy }] : [];
}
