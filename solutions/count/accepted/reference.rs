// Distance from the cross product.
//
// Seen from the centre, the cross product of B - A and A - C is |B - A| times the distance of the line from C, and
// keeps its precision wherever A and B lie along the line. The distance is compared with r within 1e-10 of the
// size.

fn line_count(cx: f64, cy: f64, r: f64, a: Pt, b: Pt) -> Option<i64> {
    if a == b {
        return None;
    }
    let (ax, ay) = (a.x - cx, a.y - cy);
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let near = 1e-10 * largest([r, ax, ay, b.x - cx, b.y - cy]);
    let gap = (dx * ay - dy * ax).abs() / dx.hypot(dy) - r;
    Some(if gap > near {
        0
    } else if gap < -near {
        2
    } else {
        1
    })
}

/// The greatest of the magnitudes.
fn largest<const N: usize>(numbers: [f64; N]) -> f64 {
    numbers.iter().fold(0.0, |most, x| x.abs().max(most))
}
