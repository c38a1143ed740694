// makerjs 0.19.2: path.intersection(Circle, Line)
//
// Coordinates are rounded to 7 digits after the point.

const { path, paths } = require('makerjs');

function circleSegment(cx, cy, r, A, B) {
  const known = atAPoint(cx, cy, r, A, B);
  if (known) return known;
  const found = (
    path.intersection(new paths.Circle([cx, cy], r), new paths.Line([A.x, A.y], [B.x, B.y])) || { intersectionPoints: [] }
  ).intersectionPoints.map(([x, y]) => ({ x, y }));
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
