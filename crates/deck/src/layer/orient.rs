//! Which way the faces of a rigid surface look: neighbours look the same way.

use super::front::{Front, cross, dot};
use std::collections::BTreeMap;

/// Why faces have no outside, by their numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Twist {
    /// Two that are neighbours, or that others join, look to opposite sides.
    Opposite([usize; 2]),
    /// More than two meet at an edge, in the plane at a node.
    Branched(Vec<usize>),
}

/// Turns faces so that all look outwards. `sides` tells of some whether they do as they are. Those that join none of these look out of the volume that they
/// enclose; where they enclose none they stay, and the first of each such surface is returned.
pub(crate) fn oriented(fronts: &mut [Front], sides: &[Option<bool>], points: &[[f64; 3]]) -> Result<Vec<usize>, Twist> {
    let mut shared: BTreeMap<[usize; 2], Vec<(usize, bool)>> = BTreeMap::new();
    for (face, front) in fronts.iter().enumerate() {
        rims(front).into_iter().for_each(|(rim, way)| shared.entry(rim).or_default().push((face, way)));
    }
    if let Some(faces) = shared.values().find(|faces| faces.len() > 2) {
        return Err(Twist::Branched(faces.iter().map(|(face, _)| *face).collect()));
    }
    let mut beside: Vec<Vec<(usize, bool)>> = vec![Vec::new(); fronts.len()];
    for faces in shared.values() {
        if let [(a, p), (b, q)] = faces[..] {
            beside[a].push((b, p == q));
            beside[b].push((a, p == q));
        }
    }
    let mut is_turned: Vec<Option<bool>> = sides.iter().map(|side| side.map(|is_out| !is_out)).collect();
    let known: Vec<usize> = (0..fronts.len()).filter(|&face| is_turned[face].is_some()).collect();
    spread(&beside, known, &mut is_turned)?;
    let mut open = Vec::new();
    for face in 0..fronts.len() {
        if is_turned[face].is_some() {
            continue;
        }
        is_turned[face] = Some(false);
        let all = spread(&beside, vec![face], &mut is_turned)?;
        let volume: f64 = all.iter().map(|&face| volume(&fronts[face], points) * sign(is_turned[face])).sum();
        if all.iter().any(|&face| beside[face].len() < rims(&fronts[face]).len()) {
            open.push(face);
        } else if volume < 0.0 {
            all.iter().for_each(|&face| is_turned[face] = is_turned[face].map(|turned| !turned));
        }
    }
    let turned = fronts.iter_mut().zip(&is_turned).filter(|(_, turned)| **turned == Some(true));
    turned.for_each(|(front, _)| front.turn());
    Ok(open)
}

/// Goes from faces to all that they join, and returns these and all of them.
fn spread(
    beside: &[Vec<(usize, bool)>],
    mut found: Vec<usize>,
    is_turned: &mut [Option<bool>],
) -> Result<Vec<usize>, Twist> {
    let mut next = 0;
    while let Some(&face) = found.get(next) {
        next += 1;
        for &(other, is_against) in &beside[face] {
            let expected = is_turned[face].map(|turned| turned != is_against);
            match is_turned[other] {
                None => {
                    is_turned[other] = expected;
                    found.push(other);
                }
                known if known != expected => return Err(Twist::Opposite([face, other])),
                _ => {}
            }
        }
    }
    Ok(found)
}

fn sign(is_turned: Option<bool>) -> f64 {
    if is_turned == Some(true) { -1.0 } else { 1.0 }
}

/// Edges, in the plane ends, each with the way in which the face has it: two faces that look the same way have it in opposite ones.
fn rims(front: &Front) -> Vec<([usize; 2], bool)> {
    let corners = &front.corners;
    if let [a, b] = corners[..] {
        return vec![([a, a], true), ([b, b], false)];
    }
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| ([a.min(b), a.max(b)], a < b)).collect()
}

/// Volume of the cone from the origin to a face, above 0 where the face looks away from there; in the plane an area.
fn volume(front: &Front, points: &[[f64; 3]]) -> f64 {
    let at = |k: usize| points[front.corners[k]];
    match front.corners.len() {
        2 => 0.5 * (at(1)[0] * at(0)[1] - at(0)[0] * at(1)[1]),
        count => (2..count).map(|k| dot(at(0), cross(at(k - 1), at(k)))).sum::<f64>() / 6.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fronts(corners: &[&[usize]]) -> Vec<Front> {
        corners.iter().map(|corners| Front { corners: corners.to_vec(), middles: Vec::new() }).collect()
    }

    /// The four faces of a tetrahedron, in any order: all look outwards, and no side need be known.
    #[test]
    fn a_closed_surface_looks_outwards() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let outwards: [&[usize]; 4] = [&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]];
        for turned in 0..16 {
            let mut all = fronts(&outwards);
            (0..4).filter(|face| turned >> face & 1 == 1).for_each(|face| all[face].turn());
            assert_eq!(oriented(&mut all, &[None; 4], &points), Ok(Vec::new()));
            let volume: f64 = all.iter().map(|front| volume(front, &points)).sum();
            assert!((volume - 1.0 / 6.0).abs() < 1e-15, "{turned}: {volume}");
        }
    }

    #[test]
    fn one_side_is_that_of_all_and_two_are_none() {
        let points = [[0.0; 3]; 6];
        let mut all = fronts(&[&[0, 1, 2], &[1, 2, 3]]);
        assert_eq!(oriented(&mut all, &[Some(false), None], &points), Ok(Vec::new()));
        assert_eq!(all, fronts(&[&[0, 2, 1], &[1, 2, 3]]));
        let mut all = fronts(&[&[0, 1, 2], &[1, 2, 3]]);
        let opposite = oriented(&mut all, &[Some(true), Some(true)], &points);
        assert_eq!(opposite, Err(Twist::Opposite([0, 1])));
        let mut branched = fronts(&[&[0, 1, 2], &[1, 2, 3], &[1, 2, 4]]);
        assert_eq!(oriented(&mut branched, &[None; 3], &points), Err(Twist::Branched(vec![0, 1, 2])));
        // A line of the plane: its second half the other way round.
        let mut line = fronts(&[&[0, 1], &[2, 1]]);
        assert_eq!(oriented(&mut line, &[Some(true), None], &points), Ok(Vec::new()));
        assert_eq!(line, fronts(&[&[0, 1], &[1, 2]]));
        assert_eq!(oriented(&mut line, &[None; 2], &points), Ok(vec![0]));
    }
}
