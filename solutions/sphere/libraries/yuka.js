// yuka 0.7.8: Ray.intersectBoundingSphere; the normal is worked out here
//
// The direction must be of length 1. From inside it gives where the ray leaves.

const { BoundingSphere, Ray, Vector3 } = require('yuka');

function raySphere(C, r, O, D) {
  const length = Math.hypot(D.x, D.y, D.z);
  if (length === 0 || r === 0) return null;
  const ray = new Ray(new Vector3(O.x, O.y, O.z), new Vector3(D.x / length, D.y / length, D.z / length));
  const found = ray.intersectBoundingSphere(new BoundingSphere(new Vector3(C.x, C.y, C.z), r), new Vector3());
  if (!found) return null;
  const t = ((found.x - O.x) * D.x + (found.y - O.y) * D.y + (found.z - O.z) * D.z) / length ** 2;
  const N = { x: (found.x - C.x) / r, y: (found.y - C.y) / r, z: (found.z - C.z) / r };
  const turn = N.x * D.x + N.y * D.y + N.z * D.z > 0 ? -1 : 1;
  return [t, { x: turn * N.x, y: turn * N.y, z: turn * N.z }];
}
