//! Contact points: the parts of a fiber inside two bodies at once.
//!
//! Along a fiber, c_a and c_b are the winding numbers of the bodies. The fiber measures ∫ c_a c_b dt, or
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
    let before = |p: &Event, q: &Event| p.t < q.t || (p.t == q.t && (p.of_b, p.source) < (q.of_b, q.source));
    if events.len() > 16 {
        events.sort_unstable_by(|p, q| p.t.total_cmp(&q.t).then((p.of_b, p.source).cmp(&(q.of_b, q.source))));
        return;
    }
    for last in 1..events.len() {
        let mut place = last;
        while place > 0 && before(&events[place], &events[place - 1]) {
            events.swap(place, place - 1);
            place -= 1;
        }
    }
}

/// Winding numbers along a fiber, from event to event.
struct LineWalk<'e> {
    events: &'e [Event],
    own: bool,
    tolerance: f64,
    cover: [i32; 2],
    next: usize,
}

/// One place on a fiber where the winding numbers may change.
struct Place<'e> {
    t: f64,
    /// The events there.
    events: &'e [Event],
    own: bool,
    before: [i32; 2],
    after: [i32; 2],
}

/// Number of pairs of layers at a point: the integrand of the measure.
fn integrand(own: bool, c: &[i32; 2]) -> f64 {
    if own { 0.5 * (c[0] * (c[0] - 1)) as f64 } else { (c[0] * c[1]) as f64 }
}

impl<'e> LineWalk<'e> {
    fn new(start: [i16; 2], events: &'e [Event], own: bool, tolerance: f64) -> Self {
        Self { events, own, tolerance, cover: start.map(i32::from), next: 0 }
    }
}

impl<'e> Iterator for LineWalk<'e> {
    type Item = Place<'e>;

    fn next(&mut self) -> Option<Place<'e>> {
        let first = self.next;
        let t = self.events.get(first)?.t;
        let before = self.cover;
        // The first event always belongs: of two infinite places the difference is none.
        while self.next < self.events.len() && (self.next == first || self.events[self.next].t - t <= self.tolerance) {
            let event = &self.events[self.next];
            self.cover[usize::from(event.of_b)] += if event.leaves { -1 } else { 1 };
            self.next += 1;
        }
        Some(Place { t, events: &self.events[first..self.next], own: self.own, before, after: self.cover })
    }
}

impl Place<'_> {
    fn change(&self) -> f64 {
        integrand(self.own, &self.after) - integrand(self.own, &self.before)
    }

    /// Calls `bound(event, coefficient)` for every event that has a part in the change.
    ///
    /// Where both bodies are entered, or both left, each carries half; where one is left and the other entered, the
    /// bodies touch and neither carries anything.
    fn share(&self, mut bound: impl FnMut(&Event, f64)) {
        let change = self.change();
        if change == 0.0 {
            return;
        }
        let opposed = (self.after[0] - self.before[0]) * (self.after[1] - self.before[1]) < 0;
        for event in self.events {
            let step = if event.leaves { -1.0 } else { 1.0 };
            let coefficient = if self.own {
                -change / self.events.len() as f64
            } else {
                let other = usize::from(!event.of_b);
                let (before, after) = (self.before[other], self.after[other]);
                -step * if opposed { before.min(after) as f64 } else { 0.5 * (before + after) as f64 }
            };
            if coefficient != 0.0 {
                bound(event, coefficient);
            }
        }
    }
}

/// Runs along sorted events, calls `bound(event, coefficient)` for each one that bounds a span, and returns the
/// measure.
///
/// `start` says how often each side covers the fiber before the first event. A fiber with ends begins at t = 0 and is
/// `length` long, and all events lie on it; a line (`None`) has no part that counts before its first event.
///
/// Crossings within the tolerance of one another happen at once.
pub(crate) fn sweep(
    start: [i16; 2],
    events: &[Event],
    own: bool,
    length: Option<f64>,
    tolerance: f64,
    mut bound: impl FnMut(&Event, f64),
) -> f64 {
    let mut open = integrand(own, &start.map(i32::from));
    let (mut measure, mut from) = (0.0, 0.0);
    for place in LineWalk::new(start, events, own, tolerance) {
        if open != 0.0 {
            measure += open * (place.t - from);
        }
        place.share(&mut bound);
        (from, open) = (place.t, integrand(own, &place.after));
    }
    match length {
        Some(length) if open != 0.0 => measure + open * (length - from),
        _ => measure,
    }
}

/// An event at an end of a span, and its part of that end.
type Bound = (Event, f64);

/// Calls `visit(entering, leaving)` for every part of a line on which the measure is positive, with the events that
/// bound it and the part of each; the parts at either end sum to 1. The winding numbers within it do not matter.
pub(crate) fn for_each_span(
    start: [i16; 2],
    events: &[Event],
    own: bool,
    tolerance: f64,
    mut visit: impl FnMut(&[Bound], &[Bound]),
) {
    let (mut entering, mut leaving): (Vec<Bound>, Vec<Bound>) = (Vec::new(), Vec::new());
    for place in LineWalk::new(start, events, own, tolerance) {
        let [before, after] = [&place.before, &place.after].map(|c| integrand(own, c) > 0.0);
        if before == after {
            continue;
        }
        let bounds = if after { &mut entering } else { &mut leaving };
        bounds.clear();
        place.share(|event, coefficient| {
            // Of the events at one place only those on their way into the span, or out of it, bound it.
            if event.leaves != after {
                bounds.push((*event, coefficient.abs()));
            }
        });
        let total: f64 = bounds.iter().map(|b| b.1).sum();
        bounds.iter_mut().for_each(|b| b.1 /= total);
        if before && !entering.is_empty() && !leaving.is_empty() {
            visit(&entering, &leaving);
        }
        if before {
            entering.clear();
        }
    }
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
        let measure = sweep([0, 0], &events, own, length, 0.0, |e, c| bounds.push((e.t, e.of_b, c)));
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
        let mut bounds = 0;
        let leaves = [event(0.25, true, true)];
        assert_eq!(sweep([1, 1], &leaves, false, Some(1.0), 0.0, |_, c| bounds += c as i32), 0.25);
        assert_eq!(bounds, 1);
        assert_eq!(sweep([1, 1], &[], false, Some(0.125), 0.0, |_, _| ()), 0.125);
        assert_eq!(sweep([1, 0], &[], false, Some(0.125), 0.0, |_, _| ()), 0.0);
    }

    #[test]
    fn spans_have_two_ends() {
        let mut events = vec![
            event(0.0, false, false),
            event(0.5, true, false),
            event(1.0, true, true),
            event(1.5, true, false),
            event(2.0, false, true),
            event(3.0, true, true),
        ];
        sort(&mut events);
        let mut spans = Vec::new();
        for_each_span([0, 0], &events, false, 0.0, |p, q| spans.push((p[0].0.t, p[0].1, q[0].0.t, q[0].1)));
        assert_eq!(spans, [(0.5, 1.0, 1.0, 1.0), (1.5, 1.0, 2.0, 1.0)]);
        let identical =
            vec![event(0.0, false, false), event(0.0, true, false), event(1.0, false, true), event(1.0, true, true)];
        for_each_span([0, 0], &identical, false, 0.0, |p, q| {
            assert_eq!([p[0].1, p[1].1, q[0].1, q[1].1], [0.5; 4]);
        });
    }

    #[test]
    fn long_and_short_fibers_sort_alike() {
        for count in [3u32, 15, 16, 17, 40] {
            let mut events: Vec<Event> =
                (0..count).map(|i| event(f64::from(i * 7919 % count), i % 2 == 0, false)).collect();
            sort(&mut events);
            assert!(events.windows(2).all(|w| w[0].t <= w[1].t));
        }
    }
}
