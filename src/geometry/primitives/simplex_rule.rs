//! Quadrature on simplices of any dimension.

/// Barycentric coordinates of a point of a simplex of up to three dimensions.
pub(crate) type InSimplex = [f64; 4];

/// Points of a rule of degree 5 on a simplex of `dimension` 1 to 3, and their weights, whose sum is 1: by Gauss, by Radon
/// (1948), and by Grundmann and Möller (1978, s = 2). Those of the first two are positive, so that sums of squares are.
pub(crate) fn degree_5(dimension: usize) -> Vec<(InSimplex, f64)> {
    let root = 15f64.sqrt();
    match dimension {
        1 => [(-root / 10.0, 5.0 / 18.0), (0.0, 4.0 / 9.0), (root / 10.0, 5.0 / 18.0)]
            .map(|(s, weight)| ([0.5 - s, 0.5 + s, 0.0, 0.0], weight))
            .to_vec(),
        2 => {
            let middle = ([1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0], 9.0 / 40.0);
            let three = [1.0, -1.0].into_iter().flat_map(|sign| {
                let (alike, weight) = ((6.0 + sign * root) / 21.0, (155.0 + sign * root) / 1200.0);
                (0..3).map(move |own| {
                    let at = |c: usize| if c == own { 1.0 - 2.0 * alike } else { alike };
                    ([at(0), at(1), at(2), 0.0], weight)
                })
            });
            std::iter::once(middle).chain(three).collect()
        }
        _ => grundmann_moeller(dimension),
    }
}

fn grundmann_moeller(dimension: usize) -> Vec<(InSimplex, f64)> {
    const S: usize = 2;
    let n = dimension;
    let factorial = |k: usize| (1..=k).map(|i| i as f64).product::<f64>();
    let mut points = Vec::new();
    for i in 0..=S {
        let denominator = (2 * S + 1 + n - 2 * i) as f64;
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        let weight = sign * 0.25f64.powi(S as i32) * denominator.powi(2 * S as i32 + 1) * factorial(n)
            / (factorial(i) * factorial(2 * S + 1 + n - i));
        for_each_power(n + 1, S - i, |powers| {
            let at = std::array::from_fn(|c| if c <= n { (2 * powers[c] + 1) as f64 / denominator } else { 0.0 });
            points.push((at, weight));
        });
    }
    points
}

/// Visits all lists of `count` whole numbers that sum up to `total`.
fn for_each_power(count: usize, total: usize, mut visit: impl FnMut(&[usize; 4])) {
    let codes = (0..(total + 1).pow(count as u32)).map(|code| {
        std::array::from_fn(|c| if c < count { code / (total + 1).pow(c as u32) % (total + 1) } else { 0 })
    });
    codes.filter(|powers: &[usize; 4]| powers.iter().sum::<usize>() == total).for_each(|powers| visit(&powers));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ of a product of powers of barycentric coordinates is n! a! b! … / (n + a + b + …)!.
    #[test]
    fn powers_up_to_the_fifth() {
        let factorial = |k: u32| (1..=k).map(f64::from).product::<f64>();
        for n in 1..=3u32 {
            let rule = degree_5(n as usize);
            for (a, b) in (0..=5u32).flat_map(|a| (0..=5 - a).map(move |b| (a, b))) {
                let found: f64 = rule.iter().map(|(x, w)| w * x[0].powi(a as i32) * x[n as usize].powi(b as i32)).sum();
                let expected = factorial(n) * factorial(a) * factorial(b) / factorial(n + a + b);
                assert!((found - expected).abs() < 1e-14, "{n}: {a}, {b}: {found} instead of {expected}");
            }
        }
    }
}
