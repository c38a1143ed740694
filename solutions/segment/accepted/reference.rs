// Half-chord from the foot.
//
// The foot of the perpendicular from the centre is the middle of both crossings: half a chord goes back and forth from
// it along the line. What is on the segment is decided by lengths along the line, within 1e-10 of the size.

fn circle_segment(cx: f64, cy: f64, r: f64, a: Pt, b: Pt) -> Vec<Pt> {
    let (ax, ay) = (a.x - cx, a.y - cy);
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let near = 1e-10 * largest([r, ax, ay, b.x - cx, b.y - cy]);
    let length = dx.hypot(dy);
    if length == 0.0 {
        let on_circle = (ax.hypot(ay) - r).abs() <= near;
        return if on_circle { vec![a] } else { vec![] };
    }
    let (ux, uy) = (dx / length, dy / length);
    let side = ux * ay - uy * ax; // of the line from the centre, along the left normal (-uy, ux)
    let to_foot = -(ux * ax + uy * ay);
    let foot = Pt { x: cx - side * uy, y: cy + side * ux };

    let d = side.abs();
    let steps = if d > r + near {
        vec![]
    } else if d >= r - near {
        vec![0.0]
    } else {
        let half = ((r - d) * (r + d)).sqrt();
        vec![-half, half]
    };
    steps
        .into_iter()
        .filter(|step| (-near..=length + near).contains(&(to_foot + step)))
        .map(|step| Pt { x: foot.x + step * ux, y: foot.y + step * uy })
        .collect()
}

/// The greatest of the magnitudes.
fn largest<const N: usize>(numbers: [f64; N]) -> f64 {
    numbers.iter().fold(0.0, |most, x| x.abs().max(most))
}
