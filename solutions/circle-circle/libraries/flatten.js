// @flatten-js/core 1.6.15: Circle.intersect(Circle)
//
// Numbers are compared with a fixed tolerance, 1e-6.

const Flatten = require('@flatten-js/core').default;

function circleCircle(cx1, cy1, r1, cx2, cy2, r2) {
  if (cx1 === cx2 && cy1 === cy2 && r1 === r2) return r1 === 0 ? [{ x: cx1, y: cy1 }] : null;
  if (r1 === 0 || r2 === 0) {
    const far = Math.hypot(cx2 - cx1, cy2 - cy1), r = r1 || r2;
    const point = r1 === 0 ? { x: cx1, y: cy1 } : { x: cx2, y: cy2 };
    return Math.abs(far - r) <= 1e-9 * Math.max(far, r) ? [point] : [];
  }
  const other = Flatten.circle(Flatten.point(cx2, cy2), r2);
  const found = Flatten.circle(Flatten.point(cx1, cy1), r1).intersect(other);
  const side = (p) => (cx2 - cx1) * (p.y - cy1) - (cy2 - cy1) * (p.x - cx1);
  const points = found.map((p) => ({ x: p.x, y: p.y })).sort((p, q) => side(q) - side(p));
  return points.filter((p, i) => i === 0 || p.x !== points[0].x || p.y !== points[0].y);
}
