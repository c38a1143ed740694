// Half-chord and the power of the origin.
//
// Half a chord before and after the foot of the perpendicular are both crossings. The one that would be a difference of
// two nearly equal lengths is taken from the other one instead: their product is the power of the origin.

fn ray_nearest(cx: f64, cy: f64, r: f64, o: Pt, d: Pt) -> Option<f64> {
    let length = d.x.hypot(d.y);
    if length == 0.0 {
        return None;
    }
    let (ux, uy) = (d.x / length, d.y / length);
    let (fx, fy) = (o.x - cx, o.y - cy);
    let near = 1e-10 * r.max(fx.abs()).max(fy.abs());

    let distance = (d.x * fy - d.y * fx).abs() / length;
    let to_foot = -(fx * ux + fy * uy);
    if distance > r + near {
        return None;
    }
    let mut ways = [to_foot, to_foot];
    if distance < r - near {
        let half = ((r - distance) * (r + distance)).sqrt();
        let far = to_foot + half.copysign(to_foot);
        let other = (fx * fx + fy * fy - r * r) / far;
        ways = [far.min(other), far.max(other)];
    }
    let first = ways.into_iter().find(|&way| way >= -near)?;
    Some(if first <= near { 0.0 } else { first / length })
}
