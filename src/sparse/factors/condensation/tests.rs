use super::*;

/// A held row of bars with springs to second neighbours, in compressed rows: offsets, columns, values.
struct Bars {
    offsets: Vec<i64>,
    columns: Vec<i64>,
    values: Vec<f64>,
}

impl Bars {
    /// Of dense rows; zeros are no entries.
    fn of(dense: &[Vec<f64>], is_there: impl Fn(usize, usize) -> bool) -> Self {
        let mut bars = Self { offsets: vec![0], columns: Vec::new(), values: Vec::new() };
        for (row, values) in dense.iter().enumerate() {
            // In descending order: the order in a row does not matter.
            for (column, value) in values.iter().enumerate().rev().filter(|(_, value)| **value != 0.0) {
                if is_there(row, column) {
                    bars.columns.push(column as i64);
                    bars.values.push(*value);
                }
            }
            bars.offsets.push(bars.values.len() as i64);
        }
        bars
    }

    fn view(&self) -> Compressed<'_> {
        Compressed { offsets: &self.offsets, columns: &self.columns, values: &self.values }
    }
}

/// Stiffness of a chain of `size` nodes, held at its first by a spring of this stiffness.
fn chain(size: usize, held: f64) -> Vec<Vec<f64>> {
    let mut dense = vec![vec![0.0; size]; size];
    dense[0][0] = held;
    for distance in 1..=2 {
        for k in 0..size - distance {
            let spring = 1.0 + (k as f64).sin().abs() / distance as f64;
            for (i, j, sign) in [(k, k, 1.0), (k + distance, k + distance, 1.0), (k, k + distance, -1.0)] {
                dense[i][j] += sign * spring;
                if i != j {
                    dense[j][i] += sign * spring;
                }
            }
        }
    }
    dense
}

fn times(dense: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    dense.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

#[test]
fn what_is_kept_and_what_follows_solve_the_whole_system() {
    let (dense, kept) = (chain(40, 2.0), [3, 17, 18, 39]);
    let (all, lower) = (Bars::of(&dense, |_, _| true), Bars::of(&dense, |row, column| row >= column));
    let x: Vec<f64> = (0..40).map(|k| (k as f64).cos()).collect();
    let right = times(&dense, &x);
    let at_kept = kept.map(|equation| x[equation]);
    for bars in [&all, &lower] {
        let mut condensation = Condensation::default();
        condensation.factorise(&bars.view(), &kept).unwrap();
        assert_eq!((condensation.size(), condensation.kept()), (Ok(40), Ok(&kept[..])));
        let left: Vec<f64> = condensation
            .complement()
            .unwrap()
            .chunks(kept.len())
            .map(|row| row.iter().zip(at_kept).map(|(s, x)| s * x).sum())
            .collect();
        let condensed = condensation.condense(&right).unwrap();
        left.iter().zip(&condensed).for_each(|(a, b)| assert!((a - b).abs() < 1e-12, "{a} is not {b}"));
        let found = condensation.expand(&right, &at_kept).unwrap();
        found.iter().zip(&x).for_each(|(a, b)| assert!((a - b).abs() < 1e-12, "{a} is not {b}"));
    }
}

#[test]
fn a_body_that_only_what_is_kept_holds_has_factors() {
    let mut condensation = Condensation::default();
    let loose = Bars::of(&chain(30, 0.0), |_, _| true);
    let refused = condensation.factorise(&loose.view(), &[]);
    assert!(matches!(refused, Err(Error::NotPositiveDefinite { .. })), "{refused:?}");
    let without = (
        condensation.size(),
        condensation.complement(),
        condensation.condense(&[0.0; 30]),
        condensation.expand(&[], &[]),
    );
    let none = || Err(Error::NotFactorised);
    assert_eq!(without, (Err(Error::NotFactorised), none(), none(), none()));
    // Its complement has no stiffness against being moved as a whole.
    condensation.factorise(&loose.view(), &[0, 29]).unwrap();
    let complement = condensation.complement().unwrap();
    assert!(complement[0] > 0.1 && (complement[0] + complement[1]).abs() < 1e-13, "{complement:?}");
}

#[test]
fn the_second_matrix_of_a_pattern_is_not_analysed() {
    let mut condensation = Condensation::default();
    for held in [1.0, 5.0] {
        condensation.factorise(&Bars::of(&chain(30, held), |_, _| true).view(), &[4]).unwrap();
    }
    assert_eq!((condensation.factorisation.analyses, condensation.factorisation.count), (1, 2));
}

#[test]
fn what_is_given_wrong_is_refused_and_changes_nothing() {
    let (mut condensation, dense) = (Condensation::default(), chain(6, 1.0));
    condensation.factorise(&Bars::of(&dense, |_, _| true).view(), &[2]).unwrap();
    let before = condensation.complement();
    let mut refused = |change: &dyn Fn(&mut Bars), kept: &[usize]| {
        let mut bars = Bars::of(&dense, |_, _| true);
        change(&mut bars);
        let error = condensation.factorise(&bars.view(), kept).unwrap_err();
        assert_eq!(condensation.complement(), before);
        error
    };
    let none = |_: &mut Bars| {};
    assert_eq!(refused(&none, &[6]), Error::DofOutOfRange { dof: 6, count: 6 });
    assert_eq!(refused(&none, &[3, 3]), Error::RepeatedDof { dof: 3 });
    assert_eq!(refused(&|bars| bars.columns[1] = -1, &[]), Error::DofOutOfRange { dof: -1, count: 6 });
    let error = refused(&|bars| bars.values[4] = f64::NAN, &[]);
    assert_eq!(error, Error::NonFiniteStiffness { array: "values", entry: 4 });
    assert_eq!(refused(&|bars| bars.values[0] += 1e-3, &[]), Error::Unsymmetric { row: 2, column: 0 });
    assert!(matches!(refused(&|bars| bars.offsets[2] = 99, &[]), Error::Length { array: "row_offsets", .. }));
    assert!(matches!(condensation.condense(&[1.0]), Err(Error::Length { array: "right", expected: 6, found: 1 })));
    assert!(matches!(
        condensation.expand(&[1.0; 6], &[f64::NAN]),
        Err(Error::NonFiniteStiffness { array: "kept", .. })
    ));
}

#[test]
fn what_a_double_cannot_hold_is_refused() {
    let mut condensation = Condensation::default();
    let scaled = |scale: f64| {
        let mut bars = Bars::of(&chain(6, 1.0), |_, _| true);
        bars.values.iter_mut().for_each(|value| *value *= scale);
        bars
    };
    condensation.factorise(&scaled(1e-300).view(), &[2]).unwrap();
    let beyond = condensation.expand(&[1e10; 6], &[0.0]);
    assert!(matches!(beyond, Err(Error::Overflow { quantity: "solution", .. })), "{beyond:?}");
    let large = Bars::of(&[vec![1.0, 0.0], vec![0.0, f64::MAX]], |_, _| true);
    let beyond = condensation.factorise(&large.view(), &[1]);
    assert!(matches!(beyond, Err(Error::Overflow { .. } | Error::NotPositiveDefinite { .. })), "{beyond:?}");
    assert_eq!(condensation.complement(), Err(Error::NotFactorised));
}
