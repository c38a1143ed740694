// toxiclibsjs 0.3.3: Circle.getTangentPoints
//
// It intersects the circle with another one over the way from P to C. From inside it gives null.

const { Circle, Vec2D } = require('toxiclibsjs').geom;

function tangentPoints(cx, cy, r, P) {
  if (r === 0) return [{ x: cx, y: cy }];
  const found = new Circle(new Vec2D(cx, cy), r).getTangentPoints(new Vec2D(P.x, P.y)) || [];
  const points = found.map((p) => ({ x: p.x, y: p.y }));
  const side = (p) => (cx - P.x) * (p.y - P.y) - (cy - P.y) * (p.x - P.x);
  points.sort((p, q) => side(q) - side(p));
  return points.filter((p, i) => i === 0 || p.x !== points[0].x || p.y !== points[0].y);
}
