// cannon-es 0.20.0: Ray.intersectBody of a Sphere, on a segment that reaches beyond it
//
// From inside it gives where the ray leaves. The discriminant is compared with 0.

const { Body, Ray, RaycastResult, Sphere, Vec3 } = require('cannon-es');

function rayNearest(cx, cy, r, O, D) {
  const length = Math.hypot(D.x, D.y);
  if (length === 0) return null;
  if (r === 0) return atAPoint(cx, cy, O, D);
  const k = (Math.hypot(cx - O.x, cy - O.y) + 2 * r) / length, hit = new RaycastResult();
  const body = new Body({ mass: 0, shape: new Sphere(r), position: new Vec3(cx, cy, 0) });
  body.updateAABB();
  new Ray(new Vec3(O.x, O.y, 0), new Vec3(O.x + k * D.x, O.y + k * D.y, 0)).intersectBody(body, hit);
  return hit.hasHit ? hit.distance / length : null;
}

// t where the circle is the point C; null where the ray misses it.
function atAPoint(cx, cy, O, D) {
  const t = ((cx - O.x) * D.x + (cy - O.y) * D.y) / (D.x * D.x + D.y * D.y);
  const off = Math.hypot(O.x + t * D.x - cx, O.y + t * D.y - cy);
  return t >= 0 && off <= 1e-9 * Math.hypot(cx - O.x, cy - O.y) ? t : null;
}
