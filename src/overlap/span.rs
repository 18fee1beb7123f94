//! Spans: stretches of a fiber inside two bodies at once.
//!
//! Along a fiber, c_a and c_b count how often each body covers the point. What the fiber measures is ∫ c_a c_b dt, or
//! ∫ c (c − 1)/2 dt for a body with itself: 1 times the length wherever no body is folded over itself. At a crossing
//! that changes the integrand from f₀ to f₁, moving it by δt changes the measure by −(f₁ − f₀) δt; that difference is
//! the crossing's coefficient. Each coefficient of a leaving crossing is ≥ 0 and of an entering one ≤ 0.

/// One crossing on a fiber.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Event {
    /// Position along the fiber.
    pub(crate) t: f64,
    /// Facet, or number of a hit on an implicit shape.
    pub(crate) source: u32,
    /// Whether it belongs to the second side.
    pub(crate) of_b: bool,
    /// Whether the fiber leaves the body here.
    pub(crate) leaves: bool,
}

/// Sorts the events of one fiber. The order of equal `t` is immaterial, but fixed.
pub(crate) fn sort(events: &mut [Event]) {
    events.sort_unstable_by(|p, q| {
        p.t.total_cmp(&q.t).then(p.of_b.cmp(&q.of_b)).then(p.source.cmp(&q.source))
    });
}

/// Runs along sorted events, calls `bound(event, coefficient)` for each one in `[0, length]` that bounds a span, and
/// returns the measure of that stretch. Lines have no ends: `length` is `None`.
///
/// Crossings at the same `t` happen at once. Where both bodies are entered, or both left, there, each carries half;
/// where one is left and the other entered, the bodies touch and neither carries anything.
pub(crate) fn sweep(events: &[Event], own: bool, length: Option<f64>, mut bound: impl FnMut(&Event, f64)) -> f64 {
    let (mut a, mut b) = (0.0, 0.0);
    let mut measure = 0.0;
    let within = |t: f64| length.is_none_or(|length| (0.0..=length).contains(&t));
    let integrand = |a: f64, b: f64| if own { 0.5 * a * (a - 1.0) } else { a * b };
    let mut start = 0.0;
    let mut open = 0.0;
    let mut first = 0;
    while first < events.len() {
        let t = events[first].t;
        let last = first + events[first..].iter().take_while(|e| e.t == t).count();
        let same = &events[first..last];
        first = last;
        let (before_a, before_b) = (a, b);
        let mut entries = [0.0; 2];
        for event in same {
            let step = if event.leaves { -1.0 } else { 1.0 };
            *(if event.of_b { &mut b } else { &mut a }) += step;
            entries[usize::from(event.of_b)] += step;
        }
        if !within(t) {
            if length.is_some() && t < 0.0 {
                open = integrand(a, b);
            }
            if t > 0.0 {
                break;
            }
            continue;
        }
        let after = integrand(a, b);
        if open != 0.0 {
            measure += open * (t - start);
        }
        let change = after - open;
        (start, open) = (t, after);
        for event in same {
            let step = if event.leaves { -1.0 } else { 1.0 };
            let coefficient = if own {
                -change / same.len() as f64
            } else {
                let (before, after) = if event.of_b { (before_a, a) } else { (before_b, b) };
                -step * if entries[0] * entries[1] < 0.0 { before.min(after) } else { 0.5 * (before + after) }
            };
            if coefficient != 0.0 {
                bound(event, coefficient);
            }
        }
    }
    if let Some(length) = length {
        measure += open * (length - start);
    }
    measure
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(t: f64, of_b: bool, leaves: bool) -> Event {
        Event { t, source: (10.0 * t) as u32, of_b, leaves }
    }

    fn measure(mut events: Vec<Event>, own: bool, length: Option<f64>) -> (f64, Vec<(f64, bool, f64)>) {
        sort(&mut events);
        let mut bounds = Vec::new();
        let measure = sweep(&events, own, length, |e, c| bounds.push((e.t, e.of_b, c)));
        (measure, bounds)
    }

    #[test]
    fn overlap_of_two_intervals() {
        let (length, bounds) = measure(
            vec![event(0.0, false, false), event(2.0, false, true), event(1.5, true, false), event(3.0, true, true)],
            false,
            None,
        );
        assert_eq!(length, 0.5);
        assert_eq!(bounds, vec![(1.5, true, -1.0), (2.0, false, 1.0)]);
    }

    #[test]
    fn touching_carries_nothing_and_identical_shares() {
        let touching =
            vec![event(0.0, false, false), event(1.0, false, true), event(1.0, true, false), event(2.0, true, true)];
        assert_eq!(measure(touching, false, None), (0.0, vec![]));
        let identical =
            vec![event(0.0, false, false), event(1.0, false, true), event(0.0, true, false), event(1.0, true, true)];
        let (length, bounds) = measure(identical, false, None);
        assert_eq!(length, 1.0);
        assert_eq!(bounds.iter().map(|b| b.2).collect::<Vec<_>>(), [-0.5, -0.5, 0.5, 0.5]);
    }

    #[test]
    fn self_overlap_counts_pairs() {
        let folded =
            vec![event(0.0, false, false), event(1.0, false, false), event(3.0, false, true), event(4.0, false, true)];
        assert_eq!(measure(folded, true, None), (2.0, vec![(1.0, false, -1.0), (3.0, false, 1.0)]));
    }

    #[test]
    fn segments_start_and_end_inside() {
        let events =
            vec![event(-1.0, false, false), event(5.0, false, true), event(-0.5, true, false), event(0.25, true, true)];
        assert_eq!(measure(events.clone(), false, Some(1.0)), (0.25, vec![(0.25, true, 1.0)]));
        assert_eq!(measure(events, false, Some(0.125)), (0.125, vec![]));
    }

    #[test]
    fn half_lines_without_end_are_harmless() {
        let events = vec![
            event(f64::NEG_INFINITY, true, false),
            event(0.0, false, false),
            event(1.0, false, true),
            event(f64::INFINITY, true, true),
        ];
        assert_eq!(measure(events, false, None).0, 1.0);
    }
}
