//! Whatever is given: an answer with finite numbers or an error, and never a panic.

use fmc_contact::contact::TangentPart;
use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, ContactForces, EnergyLaw, EnergyProfile, Error, Estimator, FiberOptions,
    FiberPattern, LineWeights, Obstacle, Options, PenetrationLaw, Pose, Resolution, Shape, Surface,
};
use proptest::prelude::*;
use proptest::test_runner::Config;

/// Mostly ordinary numbers, sometimes equal, huge, tiny or none at all.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        20 => -1.0..1.0f64,
        8 => prop::sample::select(vec![0.0, 0.25, 0.5, 1.0, -1.0]),
        1 => prop::sample::select(vec![1e-300, 1e300, -1e150, 1e-9, f64::NAN, f64::INFINITY, f64::MAX]),
    ]
}

fn estimator() -> impl Strategy<Value = Estimator> {
    let resolution = prop_oneof![
        Just(Resolution::Count(300)),
        (0.02..3.0f64).prop_map(Resolution::Spacing),
        number().prop_map(|x| Resolution::Spacing(x.abs().max(0.02))),
    ];
    let pattern = prop_oneof![
        Just(FiberPattern::Lines),
        number().prop_map(|length| FiberPattern::Isotropic { length: Some(length) }),
        Just(FiberPattern::Isotropic { length: None })
    ];
    let weights = prop_oneof![Just(LineWeights::Balance), Just(LineWeights::Consistent)];
    let fibers = (resolution, pattern, weights, any::<u64>(), any::<bool>()).prop_map(
        |(resolution, pattern, weights, seed, balance)| {
            // Segments that fill a volume with a small spacing are many; their number is what matters here.
            let few = matches!(pattern, FiberPattern::Isotropic { .. });
            let resolution = if few { Resolution::Count(300) } else { resolution };
            Estimator::Fibers(FiberOptions { pattern, weights, resolution, seed, momentum_correction: balance })
        },
    );
    prop_oneof![3 => fibers, 1 => Just(Estimator::Exact)]
}

fn shape<const D: usize>() -> impl Strategy<Value = Shape<D>> {
    (0..7usize, number(), number()).prop_map(|(kind, radius, half_height)| match kind {
        0 => Shape::HalfSpace,
        1 => Shape::Ball { radius },
        2 => Shape::Cuboid { half_extents: [radius; D] },
        3 => Shape::Cylinder { radius, half_height },
        4 => Shape::Cone { radius, half_height },
        5 => Shape::Capsule { radius, half_height },
        _ => Shape::SignedDistance(std::sync::Arc::new(move |x: &[f64; D]| {
            (x.iter().map(|x| x * x).sum::<f64>().sqrt() - radius, *x)
        })),
    })
}

/// Runs everything that a host could call; what comes out must be finite.
fn run<const D: usize>(
    coords: &[[f64; D]],
    cell_type: CellType,
    conn: &[u32],
    options: Options,
    obstacle: Obstacle<D>,
) -> Result<(), Error> {
    let surface = Surface::from_cells(coords, &[CellBlock { cell_type, conn }], Bodies::Connected)?;
    let mut contact = Contact::new(surface, options)?;
    // A bad obstacle is refused, and the contact goes on without it.
    let _ = contact.add_obstacle(obstacle);
    let finite = |result: &ContactForces<D>| {
        assert!(result.forces.iter().flatten().all(|f| f.is_finite()), "{result:?}");
        assert!(result.volume.is_finite() && result.volume >= 0.0, "{result:?}");
        assert!(result.energy.is_finite() && result.energy >= 0.0, "{result:?}");
    };
    finite(&contact.evaluate(coords)?);
    // Entries may leave the range; what is asked for is an answer, and places that exist.
    for part in [TangentPart::Full, TangentPart::Semidefinite] {
        if let Ok(tangent) = contact.tangent(coords, part) {
            let node_count = coords.len() + contact.obstacle_count();
            assert!(tangent.blocks.iter().all(|b| (b.row.max(b.col) as usize) < node_count));
        }
    }
    // Found patches are kept, and other coordinates measured along them.
    let directions = contact.keep_patches(coords)?;
    assert!(directions == 0 || contact.options().law.is_fiber());
    finite(&contact.evaluate(coords)?);
    let moved: Vec<[f64; D]> = coords.iter().map(|x| x.map(|x| x * 1.01)).collect();
    finite(&contact.evaluate(&moved)?);
    Ok(())
}

/// Two laws out of three are local, each with an estimator that may refuse it.
fn law() -> impl Strategy<Value = EnergyLaw> {
    (0..3usize, number(), number()).prop_map(|(kind, k, x)| {
        let k = if k > 1e6 { k } else { 1.0 + k.abs() };
        match kind {
            0 => EnergyLaw::Volume { stiffness: k, exponent: 1.0 + x.abs() },
            1 => EnergyLaw::fiber(k),
            _ => EnergyLaw::Fiber(PenetrationLaw {
                stiffness: k,
                profile: EnergyProfile::Linear { smoothing_length: x.abs() },
            }),
        }
    })
}

fn options() -> impl Strategy<Value = Options> {
    (law(), estimator(), any::<bool>(), any::<bool>()).prop_map(|(law, estimator, self_contact, check_cells)| Options {
        estimator,
        self_contact,
        check_cells,
        ..Options::new(law)
    })
}

/// A few cells on a few nodes: some share nodes or faces, some are inverted, some overlap.
macro_rules! any_input {
    ($name:ident, $dimension:literal, $cell_type:expr, $size:literal) => {
        proptest! {
            #![proptest_config(Config { cases: 200, failure_persistence: None, ..Config::default() })]
            #[test]
            fn $name(
                coords in prop::collection::vec(prop::array::uniform::<_, $dimension>(number()), 2 * $size + 2),
                cells in prop::collection::vec(prop::sample::subsequence((0..2 * $size as u32 + 3).collect::<Vec<_>>(), $size), 1..4),
                options in options(),
                shape in shape::<$dimension>(),
                position in prop::array::uniform::<_, $dimension>(number()),
                scale in number(),
            ) {
                let obstacle = Obstacle { shape, pose: Pose::at(position).scaled(scale) };
                let _ = run(&coords, $cell_type, &cells.concat(), options, obstacle);
            }
        }
    };
}

any_input!(triangles, 2, CellType::Tri3, 3);
any_input!(quadrilaterals, 2, CellType::Quad4, 4);
any_input!(tetrahedra, 3, CellType::Tet4, 4);
any_input!(hexahedra, 3, CellType::Hex8, 8);
any_input!(wedges, 3, CellType::Wedge6, 6);
any_input!(pyramids, 3, CellType::Pyramid5, 5);
