// Sign of the discriminant in whole numbers.
//
// The distance of the line from C is |k|/|D|, with D = B − A and the cross product k. Compared with r,
// squared and multiplied by |D|², that is a subtraction of two BigInts, which lose no digit at any size.
function exactCount(cx, cy, r, A, B) {
  const dx = B.x - A.x, dy = B.y - A.y;
  if (dx === 0n && dy === 0n) return null;
  const k = dx * (A.y - cy) - dy * (A.x - cx);
  const delta = r * r * (dx * dx + dy * dy) - k * k;
  return delta < 0n ? 0 : delta > 0n ? 2 : 1;
}
