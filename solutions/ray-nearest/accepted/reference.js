// The quadratic without cancellation.
//
// Whether the ray meets the circle is decided by lengths, |k|/|D| against r. Of the two roots q/a adds
// numbers of one sign, and the other one is c/q, because their product is c/a: so neither subtracts what is
// nearly equal.
function rayNearest(cx, cy, r, O, D) {
  const a = D.x * D.x + D.y * D.y;
  if (a === 0) return null;
  const fx = O.x - cx, fy = O.y - cy;
  const near = 1e-10 * Math.max(r, Math.abs(fx), Math.abs(fy));
  const b = fx * D.x + fy * D.y, c = fx * fx + fy * fy - r * r;
  const k = D.x * fy - D.y * fx; // b² − a·c = r²a − k²
  const length = Math.sqrt(a), gap = Math.abs(k) / length - r;
  if (gap > near) return null;

  let roots = [-b / a];
  if (gap < -near) {
    const half = Math.sqrt(r * r * a - k * k), q = b < 0 ? half - b : -b - half;
    roots = q < 0 ? [q / a, c / q] : [c / q, q / a]; // q/a is the one farther from O
  }
  for (const t of roots) {
    if (Math.abs(t) * length <= near) return 0;
    if (t > 0) return t;
  }
  return null;
}
