// @flatten-js/core 1.6.15: Circle.intersect(Line)
//
// Numbers are compared with a fixed tolerance, 1e-6, so a touch is one point within that.

const Flatten = require('@flatten-js/core').default;

function lineCount(cx, cy, r, A, B) {
  if (A.x === B.x && A.y === B.y) return null;
  if (r === 0) return onLine(cx, cy, A, B) ? 1 : 0;
  const line = Flatten.line(Flatten.point(A.x, A.y), Flatten.point(B.x, B.y));
  return Flatten.circle(Flatten.point(cx, cy), r).intersect(line).length;
}

// Whether the point C, the circle of radius 0, is on the line.
function onLine(cx, cy, A, B) {
  const ux = B.x - A.x, uy = B.y - A.y, wx = cx - A.x, wy = cy - A.y;
  const size = Math.max(...[wx, wy, cx - B.x, cy - B.y].map(Math.abs));
  return Math.abs(ux * wy - uy * wx) <= 1e-9 * size * Math.hypot(ux, uy);
}
