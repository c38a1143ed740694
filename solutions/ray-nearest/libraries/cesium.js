// @cesium/engine 24.0.0: IntersectionTests.raySphere, in the plane z = 0
//
// It gives an interval of the ray; one that begins at 0 begins inside, and its end counts here.

const { BoundingSphere, Cartesian3, IntersectionTests, Ray } = require('@cesium/engine');

function rayNearest(cx, cy, r, O, D) {
  const length = Math.hypot(D.x, D.y);
  if (length === 0) return null;
  if (r === 0) return atAPoint(cx, cy, O, D);
  const ray = new Ray(new Cartesian3(O.x, O.y, 0), new Cartesian3(D.x, D.y, 0));
  const found = IntersectionTests.raySphere(ray, new BoundingSphere(new Cartesian3(cx, cy, 0), r));
  return found ? (found.start || found.stop) / length : null;
}

// t where the circle is the point C; null where the ray misses it.
function atAPoint(cx, cy, O, D) {
  const t = ((cx - O.x) * D.x + (cy - O.y) * D.y) / (D.x * D.x + D.y * D.y);
  const off = Math.hypot(O.x + t * D.x - cx, O.y + t * D.y - cy);
  return t >= 0 && off <= 1e-9 * Math.hypot(cx - O.x, cy - O.y) ? t : null;
}
