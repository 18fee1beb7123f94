//! What is told beside the forces.

use crate::judge::Answer;
use crate::scene::distance;
use fmc_contact::overlap::Partner;

type Verdict = Result<(), String>;

/// Areas at nodes lie between nothing and the area of the facets, pressures carry the forces of each body.
pub(crate) fn fields<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    let field = answer.contact.nodal_contact(&drawn.coords).map_err(|error| format!("refused: {error}"))?;
    for body in 0..2 {
        let mut sum = [0.0; D];
        for node in drawn.scene.nodes_of(body) {
            let (pressure, area) = (field.pressure[node], field.area[node]);
            let is_sound = pressure >= 0.0 && area >= 0.0 && pressure.is_finite() && field.gap[node] <= 0.0;
            if !is_sound {
                return Err(format!("node {node}: pressure {pressure:e}, area {area:e}, gap {:e}", field.gap[node]));
            }
            (0..D).for_each(|i| sum[i] -= pressure * area * field.normal[node][i]);
        }
        let force = answer.forces.bodies[body].force;
        // Points of divided faces that are no nodes carry a part, and are not told.
        let is_told = drawn.is_straight;
        let off = distance(&[sum], &[force]);
        if is_told && off > 1e-10 * answer.size + answer.rounding {
            return Err(format!("body {body}: Σ p A n {sum:?} for {force:?}"));
        }
    }
    let lengths = |body: usize| share_of(answer, body, &field.area);
    lengths(0).and_then(|()| lengths(1))
}

/// ∫ N dA of a node over all of its facets, where facets are simplices: no node has more area than that.
fn share_of<const D: usize>(answer: &Answer<D>, body: usize, areas: &[f64]) -> Verdict {
    let coords = &answer.drawn.coords;
    let mut share = vec![0.0; coords.len()];
    for facet in answer.contact.boundary_facets().iter().filter(|facet| facet.body == body) {
        // Arcs are longer than the chords below.
        if facet.nodes.len() != D || !answer.drawn.is_straight {
            return Ok(());
        }
        let at = |k: usize| coords[facet.nodes[k] as usize];
        let edge = |k: usize| -> [f64; D] { std::array::from_fn(|i| at(k)[i] - at(0)[i]) };
        let area = if D == 2 {
            edge(1).iter().map(|x| x * x).sum::<f64>().sqrt()
        } else {
            0.5 * crate::scene::cross(&edge(1), &edge(2)).iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        facet.nodes.iter().for_each(|&node| share[node as usize] += area / D as f64);
    }
    let bound = |node: usize| share[node] * (1.0 + 1e-9) + 10.0 * answer.rounding;
    match answer.drawn.scene.nodes_of(body).find(|&node| areas[node] > bound(node)) {
        None => Ok(()),
        Some(node) => Err(format!("node {node}: area {:e} of {:e}", areas[node], share[node])),
    }
}

/// Contact points lie in both bodies' boxes, their weights are parts of 1, and their pressures sum to the resultants.
pub(crate) fn points<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    let points = answer.contact.contact_points(&drawn.coords).map_err(|error| format!("refused: {error}"))?;
    let mut sums = [[0.0; D]; 2];
    for point in &points {
        for (side, partner) in point.partners.iter().enumerate() {
            let Partner::Body(body) = *partner else { return Err(format!("{point:?}")) };
            let sign = if side == 0 { -1.0 } else { 1.0 };
            (0..D).for_each(|i| sums[body][i] += sign * point.pressure * point.area * point.normal[i]);
            let told = &point.sides[side];
            let weights = &told.weights[..told.node_count];
            let sum: f64 = weights.iter().sum();
            if (sum - 1.0).abs() > 1e-12 || weights.iter().any(|w| !(-1e-9..=1.0 + 1e-9).contains(w)) {
                return Err(format!("weights {weights:?}"));
            }
            for i in 0..D {
                let inside = drawn.scene.nodes_of(body).map(|node| drawn.coords[node][i]);
                let (low, high) = inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
                // Curved faces go beyond their nodes.
                let bulge = if drawn.is_straight { 0.0 } else { 0.02 };
                let bound = (1e-8 + bulge + 10.0 * drawn.rounding) * drawn.size;
                let at = point.position[i];
                if !(low - bound..=high + bound).contains(&at) {
                    return Err(format!("at {at:e}, body {body} from {low:e} to {high:e}"));
                }
            }
        }
        if !(point.pressure >= 0.0 && point.area >= 0.0 && point.gap <= 0.0) {
            return Err(format!("pressure {:e}, area {:e}, gap {:e}", point.pressure, point.area, point.gap));
        }
    }
    // On curved faces a pressure acts along the gradient of the depth, which is not the normal of a facet.
    let summed = if drawn.is_straight { &sums[..] } else { &[] };
    for (body, sum) in summed.iter().enumerate() {
        let force = answer.forces.bodies[body].force;
        if distance(&[*sum], &[force]) > 1e-10 * answer.size + answer.rounding {
            return Err(format!("body {body}: Σ p A n {sum:?} for {force:?}"));
        }
    }
    Ok(())
}
