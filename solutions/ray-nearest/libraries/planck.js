// planck 1.4.2: CircleShape.rayCast, on a segment that reaches beyond the circle
//
// Its circle is a disc: a ray that starts inside hits nothing.

const { Circle, Transform, Vec2 } = require('planck');

function rayNearest(cx, cy, r, O, D) {
  const length = Math.hypot(D.x, D.y);
  if (length === 0) return null;
  if (r === 0) return atAPoint(cx, cy, O, D);
  const k = (Math.hypot(cx - O.x, cy - O.y) + 2 * r) / length, hit = {};
  const to = Vec2(O.x + k * D.x, O.y + k * D.y);
  const ray = { p1: Vec2(O.x, O.y), p2: to, maxFraction: 1 };
  return Circle(Vec2(cx, cy), r).rayCast(hit, ray, Transform.identity()) ? hit.fraction * k : null;
}

// t where the circle is the point C; null where the ray misses it.
function atAPoint(cx, cy, O, D) {
  const t = ((cx - O.x) * D.x + (cy - O.y) * D.y) / (D.x * D.x + D.y * D.y);
  const off = Math.hypot(O.x + t * D.x - cx, O.y + t * D.y - cy);
  return t >= 0 && off <= 1e-9 * Math.hypot(cx - O.x, cy - O.y) ? t : null;
}
