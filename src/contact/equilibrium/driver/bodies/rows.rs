//! What is near: mean gaps of nodes, and how motions change them.

use crate::Error;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::history::sorted;
use crate::contact::results::GapConstraints;
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Slopes by unknown.
type Slopes = Vec<(usize, f64)>;

/// Gaps within a reach.
pub(crate) struct Rows {
    /// Mean gap at a node.
    pub(crate) gap: Vec<f64>,
    /// Area for which it stands.
    pub(crate) area: Vec<f64>,
    /// Stiffness of the pair by displacement: k by area, halved where both sides have rows.
    pub(crate) weight: Vec<f64>,
    /// Derivative of the mean gap.
    slopes: Vec<Slopes>,
    /// Its tangential counterparts: the row, and the derivative of the jump along a tangent.
    pub(crate) tangential: Vec<(usize, Slopes)>,
    /// Between whom.
    pub(crate) partners: Vec<[Partner; 2]>,
}

impl Rows {
    /// Those within a reach; `None` where there are none.
    pub(crate) async fn near<const D: usize>(host: &Host<D>, x: &[f64], reach: f64) -> Result<Option<Self>, Trouble> {
        let coords = host.unknowns.coords(x);
        let found = host.contact(move |contact| {
            let gaps = contact.gap_constraints(&coords, reach)?;
            let stiffness: Vec<f64> = gaps.partners.iter().map(|pair| contact.stiffness_of_pair(*pair)).collect();
            Ok::<_, Error>((gaps, stiffness))
        });
        let (gaps, stiffness) = found.await?;
        let mut rows =
            Self { gap: vec![], area: vec![], weight: vec![], slopes: vec![], tangential: vec![], partners: vec![] };
        for row in (0..gaps.gaps.len()).filter(|&row| gaps.areas[row] > 0.0) {
            rows.push(host, &gaps, row, stiffness[row]);
        }
        Ok((!rows.gap.is_empty()).then_some(rows))
    }

    fn push<const D: usize>(&mut self, host: &Host<D>, gaps: &GapConstraints<D>, row: usize, stiffness: f64) {
        let area = gaps.areas[row];
        let range = gaps.row_starts[row]..gaps.row_starts[row + 1];
        let by_unknown = |of: &dyn Fn(&Vector<D>) -> Vector<D>| {
            let mut sums = BTreeMap::new();
            for (&column, slope) in gaps.columns[range.clone()].iter().zip(&gaps.slopes[range.clone()]) {
                let value = of(&Vector::from(*slope)) / area;
                for axis in 0..D {
                    for (unknown, weight) in host.unknowns.of(column as usize * D + axis) {
                        *sums.entry(unknown).or_insert(0.0) += weight * value[axis];
                    }
                }
            }
            sums.into_iter().collect::<Slopes>()
        };
        let number = self.gap.len();
        let has_twin = matches!(gaps.partners[row], [_, Partner::Body(_)]);
        self.gap.push(gaps.gaps[row] / area);
        self.area.push(area);
        self.partners.push(sorted(gaps.partners[row]));
        self.weight.push(stiffness * area * if has_twin { 0.5 } else { 1.0 });
        self.slopes.push(by_unknown(&|slope| *slope));
        let away = Vector::<D>::from(gaps.away[row]);
        if away.norm() > 0.0 {
            let normal = away.normalize();
            for tangent in tangents(&normal) {
                self.tangential.push((number, by_unknown(&|slope| tangent * slope.dot(&normal))));
            }
        }
    }

    /// Change of every gap by a step.
    pub(crate) fn along(&self, step: &[f64]) -> Vec<f64> {
        self.slopes.iter().map(|slopes| along(slopes, step)).collect()
    }
}

/// Change of one row's quantity by a step.
pub(crate) fn along(slopes: &[(usize, f64)], step: &[f64]) -> f64 {
    slopes.iter().map(|(unknown, slope)| slope * step[*unknown]).sum()
}

/// Unit vectors across a normal.
fn tangents<const D: usize>(normal: &Vector<D>) -> Vec<Vector<D>> {
    let least = (0..D).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(0);
    let mut first = Vector::<D>::zeros();
    first[least] = 1.0;
    first -= *normal * normal[least];
    let first = first.normalize();
    if D == 2 {
        return vec![first];
    }
    let across = |i: usize| normal[(i + 1) % 3] * first[(i + 2) % 3] - normal[(i + 2) % 3] * first[(i + 1) % 3];
    vec![first, Vector::from_fn(|i, _| across(i))]
}
