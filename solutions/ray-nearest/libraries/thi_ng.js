// @thi.ng/geom-isec 4.0.95: intersectRayCircle
//
// The direction must be of length 1. From inside it gives where the ray leaves; the discriminant is compared with 0.

const { intersectRayCircle } = require('@thi.ng/geom-isec');

function rayNearest(cx, cy, r, O, D) {
  const length = Math.hypot(D.x, D.y);
  if (length === 0) return null;
  if (r === 0) return atAPoint(cx, cy, O, D);
  const found = intersectRayCircle([O.x, O.y], [D.x / length, D.y / length], [cx, cy], r);
  return found.isec ? found.alpha / length : null;
}

// t where the circle is the point C; null where the ray misses it.
function atAPoint(cx, cy, O, D) {
  const t = ((cx - O.x) * D.x + (cy - O.y) * D.y) / (D.x * D.x + D.y * D.y);
  const off = Math.hypot(O.x + t * D.x - cx, O.y + t * D.y - cy);
  return t >= 0 && off <= 1e-9 * Math.hypot(cx - O.x, cy - O.y) ? t : null;
}
