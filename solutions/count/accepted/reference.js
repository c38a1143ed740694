// Distance from the cross product.
//
// Seen from the centre, the cross product of B − A and A − C is |B − A| times the distance of the line, and
// is known wherever A and B are on it. The distance is compared with r within 1e-10 of the size, which is
// more than rounding and less than what is promised.
function lineCount(cx, cy, r, A, B) {
  const dx = B.x - A.x, dy = B.y - A.y;
  if (dx === 0 && dy === 0) return null;
  const fx = A.x - cx, fy = A.y - cy;
  const size = Math.max(r, Math.abs(fx), Math.abs(fy), Math.abs(B.x - cx), Math.abs(B.y - cy));
  const gap = Math.abs(dx * fy - dy * fx) / Math.sqrt(dx * dx + dy * dy) - r;
  if (Math.abs(gap) <= 1e-10 * size) return 1;
  return gap < 0 ? 2 : 0;
}
