// Foot and half-chord, between the ends.
//
// All places on the line are lengths counted from A: the foot of the perpendicular, half a chord before it
// and after it, and the end B. The points come from the foot as the centre sees it, so that they are exact
// even where A is far away.
function circleSegment(cx, cy, r, A, B) {
  const fx = A.x - cx, fy = A.y - cy;
  const dx = B.x - A.x, dy = B.y - A.y;
  const near = 1e-10 * Math.max(r, Math.abs(fx), Math.abs(fy), Math.abs(B.x - cx), Math.abs(B.y - cy));
  const length = Math.sqrt(dx * dx + dy * dy);
  if (length === 0) return Math.abs(Math.sqrt(fx * fx + fy * fy) - r) <= near ? [A] : [];

  const ux = dx / length, uy = dy / length;
  const side = ux * fy - uy * fx; // of the line from C, to the left
  const foot = -(ux * fx + uy * fy);
  const d = Math.abs(side);
  if (d > r + near) return [];
  const half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
  return (half > 0 ? [-half, half] : [0])
    .filter(step => -near <= foot + step && foot + step <= length + near)
    .map(step => ({ x: cx - side * uy + step * ux, y: cy + side * ux + step * uy }));
}
