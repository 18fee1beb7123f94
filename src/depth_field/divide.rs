//! Simplices divided about points between their corners.

/// A point between corners of a simplex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between {
    /// Bit k is set where corner k has a part in the point.
    pub(super) corners: u8,
    pub(super) number: u8,
    /// Another point that has a part in it.
    pub(super) about: Option<u8>,
}

/// Calls `visit(corners, which of them are those of the simplex)` for the simplices into which one with these corners is
/// divided about points, those between most corners first. Corners keep their places, and so their orientation.
///
/// The simplices about a point stand on the faces of the simplex, or of its face or edge, in which the point lies. How a
/// face is divided depends on the points in it alone, so that two simplices at the face agree.
pub(super) fn divide(corners: [u8; 4], points: &[Between], visit: &mut dyn FnMut([u8; 4], u8)) {
    divide_face(corners, 0b1111, points, visit);
}

/// The same with the face of the corners `of` divided, the other corners being points already.
fn divide_face(corners: [u8; 4], of: u8, points: &[Between], visit: &mut dyn FnMut([u8; 4], u8)) {
    let places = |point: &Between| -> Option<u8> {
        let is_there = point.corners & !of == 0;
        let about = match point.about {
            Some(other) => 1 << (0..4).find(|&k| of >> k & 1 == 0 && corners[k] == other)?,
            None => 0,
        };
        is_there.then_some(point.corners | about)
    };
    let found = points.iter().find_map(|point| Some((point.number, places(point)?)));
    let Some((number, places)) = found else { return visit(corners, of) };
    for k in (0..4).filter(|k| places >> k & 1 == 1) {
        let mut about = corners;
        about[k] = number;
        divide_face(about, of & !(1 << k), points, visit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(points: &[u8]) -> usize {
        let points: Vec<Between> =
            (4..).zip(points).map(|(number, &corners)| Between { corners, number, about: None }).collect();
        let mut count = 0;
        divide([0, 1, 2, 3], &points, &mut |_, _| count += 1);
        count
    }

    /// With all points there are as many simplices as ways to go from a corner over an edge and a face to the middle.
    #[test]
    fn numbers_of_simplices() {
        let (middle, faces, edges) = (0b1111, [0b0111, 0b1011, 0b1101, 0b1110], [3, 5, 6, 9, 10, 12]);
        assert_eq!(count(&[]), 1);
        assert_eq!(count(&[middle]), 4);
        assert_eq!(count(&[0b0111]), 3);
        assert_eq!(count(&[0b0011]), 2);
        assert_eq!(count(&[0b0011, 0b1100]), 4);
        assert_eq!(count(&[middle, faces[0]]), 6);
        assert_eq!(count(&[[middle].as_slice(), &faces, &edges].concat()), 24);
    }
}
