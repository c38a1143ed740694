// @mathigon/euclid 1.2.4: intersections(Line, Circle)
//
// Numbers are compared with a fixed tolerance, 1e-6.

const { Circle, Line, Point, intersections } = require('@mathigon/euclid');

function lineCount(cx, cy, r, A, B) {
  if (A.x === B.x && A.y === B.y) return null;
  if (r === 0) return onLine(cx, cy, A, B) ? 1 : 0;
  const line = new Line(new Point(A.x, A.y), new Point(B.x, B.y));
  return intersections(line, new Circle(new Point(cx, cy), r)).length;
}

// Whether the point C, the circle of radius 0, is on the line.
function onLine(cx, cy, A, B) {
  const ux = B.x - A.x, uy = B.y - A.y, wx = cx - A.x, wy = cy - A.y;
  const size = Math.max(...[wx, wy, cx - B.x, cy - B.y].map(Math.abs));
  return Math.abs(ux * wy - uy * wx) <= 1e-9 * size * Math.hypot(ux, uy);
}
