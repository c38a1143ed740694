// Sign of r²·a - k².
//
// The distance of the line from C is |k| / √a, with the cross product k and a = |B - A|². It is compared with r after
// both were squared and multiplied by a, in integers and so exactly. Rust's own have 128 bits and these have any size,
// so they come as text and are held as digits of nine decimals.

fn exact_count(cx: String, cy: String, r: String, a: IntPt, b: IntPt) -> Option<i64> {
    let [cx, cy, r, ax, ay, bx, by] = [cx, cy, r, a.x, a.y, b.x, b.y].map(|digits| Int::parse(&digits));
    let (dx, dy) = (bx.plus(&ax, -1), by.plus(&ay, -1));
    if dx.sign() == 0 && dy.sign() == 0 {
        return None;
    }
    let (fx, fy) = (ax.plus(&cx, -1), ay.plus(&cy, -1));
    let a = dx.times(&dx).plus(&dy.times(&dy), 1);
    let k = dx.times(&fy).plus(&dy.times(&fx), -1);
    let delta = r.times(&r).times(&a).plus(&k.times(&k), -1);
    Some(1 + delta.sign())
}

const BASE: i64 = 1_000_000_000;

/// An integer: its digits, the lowest first. Only the highest one, which is not 0, may be below 0.
struct Int(Vec<i64>);

impl Int {
    fn parse(word: &str) -> Int {
        let decimals = word.trim_start_matches(['+', '-']);
        let sign = if word.starts_with('-') { -1 } else { 1 };
        let digit = |nine: &[u8]| nine.iter().fold(0, |n, c| 10 * n + sign * (c - b'0') as i64);
        Int::carried(decimals.as_bytes().rchunks(9).map(digit).collect())
    }

    /// The number of these digits, which may be of any sign and too large.
    fn carried(mut digits: Vec<i64>) -> Int {
        for i in 1..digits.len() {
            digits[i] += digits[i - 1].div_euclid(BASE);
            digits[i - 1] = digits[i - 1].rem_euclid(BASE);
        }
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Int(digits)
    }

    /// The sum; with the sign -1 the difference.
    fn plus(&self, other: &Int, sign: i64) -> Int {
        let at = |digits: &[i64], i: usize| digits.get(i).copied().unwrap_or(0);
        let places = 0..self.0.len().max(other.0.len());
        Int::carried(places.map(|i| at(&self.0, i) + sign * at(&other.0, i)).collect())
    }

    fn times(&self, other: &Int) -> Int {
        let mut digits = vec![0; self.0.len() + other.0.len() + 1];
        for (i, x) in self.0.iter().enumerate() {
            for (j, y) in other.0.iter().enumerate() {
                let sum = digits[i + j] + x * y; // at most 2·BASE each: it fits
                digits[i + j] = sum.rem_euclid(BASE);
                digits[i + j + 1] += sum.div_euclid(BASE);
            }
        }
        Int::carried(digits)
    }

    fn sign(&self) -> i64 {
        self.0.last().map_or(0, |highest| highest.signum())
    }
}
