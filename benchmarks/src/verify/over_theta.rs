//! Value and derivative over θ, beside their closed forms, as in the paper's figures.

use super::case::Case;
use super::closed_form::ClosedForm;
use super::method::Method;
use super::row::Row;
use crate::chart::{Axis, Mark, Panel, Series};

/// Points on the curve of a closed form: smooth to the eye.
const CURVE_POINTS: usize = 150;

/// The two panels of a case, from its meshed rows.
pub(super) fn over_theta<const D: usize>(case: &Case<D>, methods: &[Method], rows: &[Row]) -> Vec<Panel> {
    let measure = if D == 2 { "area" } else { "volume" };
    let panel = |quantity: &str, label: String, of: fn(&ClosedForm) -> f64| {
        let [from, to] = case.range;
        let theta = |k: usize| from + (to - from) * k as f64 / CURVE_POINTS as f64;
        let curve = (0..=CURVE_POINTS).map(|k| (theta(k), of(&(case.closed_form)(theta(k))))).collect();
        let mut series = vec![Series::line("closed form", (60, 60, 60), curve)];
        for &method in methods {
            let of_method = |row: &&Row| {
                (row.case, row.form, row.estimator, row.quantity) == (case.name, "mesh", method.name(), quantity)
            };
            let points = rows.iter().filter(of_method).map(|row| (row.theta, row.computed)).collect();
            series.push(method.series(Mark::Points, points));
        }
        Panel { x: Axis::linear("θ"), y: Axis::linear(label), series }
    };
    vec![
        panel("value", format!("{measure} of the overlap"), |c| c.value),
        panel("derivative", "its derivative with respect to θ".to_string(), |c| c.derivative),
    ]
}
