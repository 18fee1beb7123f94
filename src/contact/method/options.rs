//! Options of an evaluation.

use crate::Error;
use crate::contact::friction::Friction;
use crate::contact::laws::EnergyLaw;
use crate::geometry::Weighting;
use crate::overlap::{Estimator, Resolution};
use crate::sampling::FiberPattern;

/// Options of an evaluation. `Options::new(law)` sets the rest to its defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Energy law and its stiffness.
    pub law: EnergyLaw,
    /// How overlap is measured.
    pub estimator: Estimator,
    /// Threads; the result does not depend on them. Default 1, as the host may have threads of its own.
    pub threads: usize,
    /// Self-contact: also evaluate the overlap of each body with itself. Off by default: it lays lines through whole
    /// bodies.
    pub self_contact: bool,
    /// Friction of all pairs that have none of their own. Off by default. With it the tangent is unsymmetric, and steps
    /// are begun and committed: see `Contact::begin_step`.
    pub friction: Friction,
    /// Axisymmetry, in 2D: coordinates are (r, z) with r ≥ 0, and everything is that of bodies of revolution about r = 0:
    /// volumes, areas, energies, and forces on whole rings. Off by default.
    pub axisymmetric: bool,
    /// Check the orientation of every cell at every evaluation. On by default; it costs some ns per cell.
    pub check_cells: bool,
}

impl Options {
    /// Defaults with this law.
    pub fn new(law: EnergyLaw) -> Self {
        Self {
            law,
            estimator: Estimator::default(),
            threads: 1,
            self_contact: false,
            friction: Friction::default(),
            axisymmetric: false,
            check_cells: true,
        }
    }

    /// What measures count for.
    pub(crate) fn weighting(&self) -> Weighting {
        if self.axisymmetric { Weighting::Axisymmetric } else { Weighting::Plain }
    }

    /// Checks what axisymmetry excludes.
    fn check_axisymmetry(&self) -> Result<(), Error> {
        let is_isotropic = match &self.estimator {
            Estimator::Fibers(fibers) => fibers.pattern != FiberPattern::Lines,
            _ => false,
        };
        let what = match () {
            () if !self.axisymmetric => return Ok(()),
            () if is_isotropic => "isotropic fibers with axisymmetry: use FiberPattern::Lines",
            () => return Ok(()),
        };
        Err(Error::Unsupported { what })
    }

    /// Checks every value.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self.law {
            // The stiffness comes later.
            EnergyLaw::Depth { .. } | EnergyLaw::Fiber(_) if self.law.is_without_stiffness() => {
                self.law.with_stiffness(1.0).check()?;
            }
            law => law.check()?,
        }
        self.friction.check()?;
        self.check_axisymmetry()?;
        let is_rubbed_volume = self.friction.is_active() && matches!(self.law, EnergyLaw::Volume { .. });
        if is_rubbed_volume && self.friction.stiffness.is_none() && self.friction.memoryless_slip.is_none() {
            let what = "friction with the law volume, which has no penetration stiffness: set friction_stiffness";
            return Err(Error::Unsupported { what });
        }
        let positive = |name, value: f64| {
            if value.is_finite() && value > 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
        };
        if self.threads == 0 {
            return Err(Error::NotPositive { name: "threads", value: 0.0 });
        }
        if let Estimator::Fibers(fibers) | Estimator::Auto(fibers) = &self.estimator {
            if matches!(self.estimator, Estimator::Auto(_)) && fibers.pattern != FiberPattern::Lines {
                let what = "isotropic fibers chosen automatically: use the estimator fibers";
                return Err(Error::Unsupported { what });
            }
            if self.law.is_fiber() && fibers.pattern != FiberPattern::Lines {
                let what = "the fiber law on isotropic fibers: its lines run along the contact normal; use FiberPattern::Lines";
                return Err(Error::Unsupported { what });
            }
            match fibers.resolution {
                Resolution::Auto => {}
                Resolution::Count(count) => positive("fiber_count", count as f64)?,
                Resolution::Spacing(spacing) => positive("spacing", spacing)?,
            }
            if let FiberPattern::Isotropic { length: Some(length) } = fibers.pattern {
                positive("fiber_length", length)?;
            }
        }
        Ok(())
    }
}
