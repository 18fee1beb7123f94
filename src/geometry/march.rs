//! Crossings of lines with a signed distance function, all lines in step.

use super::shapes::Hit;
use super::{Pose, SignedDistance, Vector};

/// Largest number of rounds; a round costs one batch. Sphere tracing needs some tens, an interval's bracketing as many;
/// a line that runs along the boundary needs its length by the resolution, and is refused where it needs more.
pub(crate) const ROUNDS: usize = 20_000;

/// Why lines have no intersections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum MarchFailure {
    /// The function failed at this point of its batch, or was not finite, or had no gradient where φ = 0.
    AtPoint(usize),
    /// So many lines were not at their ends after the last round.
    Unfinished(usize),
}

/// A piece of a line to be searched: from `t` to `end`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SearchInterval<const D: usize> {
    pub(crate) origin: Vector<D>,
    pub(crate) direction: Vector<D>,
    pub(crate) start: f64,
    pub(crate) end: f64,
}

/// Where a search interval passes the boundary: which one, where, and whether it leaves the body there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Intersection<const D: usize> {
    pub(crate) fiber: usize,
    pub(crate) hit: Hit<D>,
    pub(crate) leaves: bool,
}

/// State of one interval: it steps until the sign changes, then the bracket is closed.
enum State {
    Step { t: f64, phi: f64, next: f64 },
    Bracket { low: f64, low_phi: f64, high: f64, high_phi: f64, at: f64, resume: f64, resume_phi: f64 },
    Done,
}

/// All intersections, by interval and then along it; an interval that starts inside has one at −∞.
///
/// From t, no boundary lies nearer than |φ|, so a step of |φ| is safe; steps are at least `resolution`, and two
/// intersections closer than that may both be missed. A change of sign is closed to rounding by regula falsi
/// (Illinois).
///
/// # Errors
/// As [`MarchFailure`] says.
pub(crate) fn march<const D: usize>(
    function: &dyn SignedDistance<D>,
    pose: &Pose<D>,
    intervals: &[SearchInterval<D>],
    resolution: f64,
) -> Result<Vec<Intersection<D>>, MarchFailure> {
    let mut intersections: Vec<Intersection<D>> = Vec::new();
    let mut states: Vec<State> =
        intervals.iter().map(|s| State::Step { t: f64::NAN, phi: f64::NAN, next: s.start }).collect();
    let mut active: Vec<usize> = (0..intervals.len()).collect();
    for _ in 0..ROUNDS {
        if active.is_empty() {
            break;
        }
        let at: Vec<f64> = active
            .iter()
            .map(|&s| match states[s] {
                State::Step { next, .. } => next,
                State::Bracket { at, .. } => at,
                State::Done => intervals[s].end,
            })
            .collect();
        let (phi, normals) = evaluate(function, pose, intervals, &active, &at).map_err(MarchFailure::AtPoint)?;
        for (n, &s) in active.iter().enumerate() {
            let (t, value, end) = (at[n], phi[n], intervals[s].end);
            let mut found = |t: f64, leaves: bool| {
                intersections.push(Intersection { fiber: s, hit: Hit { t, normal: normals[n] }, leaves });
            };
            // A value of exactly 0 counts as outside, so that every interval has a sign everywhere.
            states[s] = match states[s] {
                State::Step { t: before, phi: before_phi, .. } => {
                    if before.is_nan() && value < 0.0 {
                        found(f64::NEG_INFINITY, false);
                    }
                    if !before.is_nan() && (value < 0.0) != (before_phi < 0.0) {
                        bracket(before, before_phi, t, value, t, value)
                    } else if t >= end {
                        State::Done
                    } else {
                        State::Step { t, phi: value, next: (t + value.abs().max(resolution)).min(end) }
                    }
                }
                State::Bracket { low, low_phi, high, high_phi, resume, resume_phi, .. } => {
                    let tolerance = 4.0 * f64::EPSILON * (t.abs() + resolution);
                    if value == 0.0 || high - low <= tolerance {
                        if normals[n].norm_squared() == 0.0 {
                            return Err(MarchFailure::AtPoint(n));
                        }
                        found(t, low_phi < 0.0);
                        if resume >= end {
                            State::Done
                        } else {
                            let next = (resume + resume_phi.abs().max(resolution)).min(end);
                            State::Step { t: resume, phi: resume_phi, next }
                        }
                    } else if (value < 0.0) == (low_phi < 0.0) {
                        bracket(t, value, high, 0.5 * high_phi, resume, resume_phi)
                    } else {
                        bracket(low, 0.5 * low_phi, t, value, resume, resume_phi)
                    }
                }
                State::Done => State::Done,
            };
        }
        active.retain(|&s| !matches!(states[s], State::Done));
    }
    if !active.is_empty() {
        return Err(MarchFailure::Unfinished(active.len()));
    }
    intersections.sort_by(|p, q| p.fiber.cmp(&q.fiber).then(p.hit.t.total_cmp(&q.hit.t)));
    Ok(intersections)
}

/// Next point of a bracket: where the chord crosses zero, or the middle where rounding leaves no chord.
fn bracket(low: f64, low_phi: f64, high: f64, high_phi: f64, resume: f64, resume_phi: f64) -> State {
    let chord = low - low_phi * (high - low) / (high_phi - low_phi);
    let at = if chord > low && chord < high { chord } else { low + 0.5 * (high - low) };
    State::Bracket { low, low_phi, high, high_phi, at, resume, resume_phi }
}

/// φ and the unit outward normal in space at one point of every active interval.
#[allow(clippy::type_complexity)]
fn evaluate<const D: usize>(
    function: &dyn SignedDistance<D>,
    pose: &Pose<D>,
    intervals: &[SearchInterval<D>],
    active: &[usize],
    at: &[f64],
) -> Result<(Vec<f64>, Vec<Vector<D>>), usize> {
    let place = |(&s, &t): (&usize, &f64)| pose.unplace(&(intervals[s].origin + intervals[s].direction * t)).into();
    let x: Vec<[f64; D]> = active.iter().zip(at).map(place).collect();
    let mut phi = vec![f64::NAN; x.len()];
    let mut gradient = vec![[f64::NAN; D]; x.len()];
    function.evaluate(&x, &mut phi, &mut gradient)?;
    if let Some(point) = phi.iter().position(|p| !p.is_finite()) {
        return Err(point);
    }
    phi.iter_mut().for_each(|p| *p *= pose.scale);
    let normal = |g: &[f64; D]| pose.rotate(&Vector::from(*g)).try_normalize(0.0).unwrap_or_else(Vector::zeros);
    Ok((phi, gradient.iter().map(normal).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plane y = 0, and lines along it at a height of 0 and of 1, from x = 0 to 1.
    fn along_a_plane(resolution: f64) -> Result<usize, MarchFailure> {
        let plane = |x: &[f64; 2]| (x[1], [0.0, 1.0]);
        let line = |y: f64| SearchInterval {
            origin: Vector::<2>::new(0.0, y),
            direction: Vector::<2>::new(1.0, 0.0),
            start: 0.0,
            end: 1.0,
        };
        march(&plane, &Pose::at([0.0; 2]), &[line(0.0), line(1.0), line(0.0)], resolution).map(|found| found.len())
    }

    #[test]
    fn lines_that_are_not_searched_to_their_ends_are_counted() {
        // The last step is at the end itself.
        assert_eq!(along_a_plane(1.0 / (ROUNDS as f64 - 2.0)), Ok(0));
        assert_eq!(along_a_plane(1.0 / (ROUNDS as f64 + 2.0)), Err(MarchFailure::Unfinished(2)));
    }
}
