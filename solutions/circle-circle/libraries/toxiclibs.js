// toxiclibsjs 0.3.3: Circle.intersectsCircle
//
// The distance is compared with r1 + r2 and |r1 - r2| without any room; it gives null for none.

const { Circle, Vec2D } = require('toxiclibsjs').geom;

function circleCircle(cx1, cy1, r1, cx2, cy2, r2) {
  if (cx1 === cx2 && cy1 === cy2 && r1 === r2) return r1 === 0 ? [{ x: cx1, y: cy1 }] : null;
  if (r1 === 0 || r2 === 0) {
    const far = Math.hypot(cx2 - cx1, cy2 - cy1), r = r1 || r2;
    const point = r1 === 0 ? { x: cx1, y: cy1 } : { x: cx2, y: cy2 };
    return Math.abs(far - r) <= 1e-9 * Math.max(far, r) ? [point] : [];
  }
  const other = new Circle(new Vec2D(cx2, cy2), r2);
  const found = new Circle(new Vec2D(cx1, cy1), r1).intersectsCircle(other) || [];
  const side = (p) => (cx2 - cx1) * (p.y - cy1) - (cy2 - cy1) * (p.x - cx1);
  const points = found.map((p) => ({ x: p.x, y: p.y })).sort((p, q) => side(q) - side(p));
  return points.filter((p, i) => i === 0 || p.x !== points[0].x || p.y !== points[0].y);
}
