// yuka 0.7.8: Ray.intersectBoundingSphere, in the plane z = 0
//
// The direction must be of length 1. From inside it gives where the ray leaves.

const { BoundingSphere, Ray, Vector3 } = require('yuka');

function rayNearest(cx, cy, r, O, D) {
  const length = Math.hypot(D.x, D.y);
  if (length === 0) return null;
  if (r === 0) return atAPoint(cx, cy, O, D);
  const ray = new Ray(new Vector3(O.x, O.y, 0), new Vector3(D.x / length, D.y / length, 0));
  const found = ray.intersectBoundingSphere(new BoundingSphere(new Vector3(cx, cy, 0), r), new Vector3());
  return found ? ((found.x - O.x) * D.x + (found.y - O.y) * D.y) / length ** 2 : null;
}

// t where the circle is the point C; null where the ray misses it.
function atAPoint(cx, cy, O, D) {
  const t = ((cx - O.x) * D.x + (cy - O.y) * D.y) / (D.x * D.x + D.y * D.y);
  const off = Math.hypot(O.x + t * D.x - cx, O.y + t * D.y - cy);
  return t >= 0 && off <= 1e-9 * Math.hypot(cx - O.x, cy - O.y) ? t : null;
}
