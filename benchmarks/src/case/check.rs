//! What a case must fulfil beyond the types of its values.

use super::size::{MOST_LOAD_STEPS, MOST_NODES, MOST_STEPS};
use super::{Case, FigureKind, Key, LawName, Load, MeshSource, Obstacle, Place, Support};
use fmc_contact::Shape;
use fmc_solid::statics::LARGEST_TOLERANCE;

mod contact;
mod mesh;

/// Everything that is wrong with a case: the key to blame, and what would be right.
pub(super) fn flaws(case: &Case) -> Vec<(Key, String)> {
    let mut check = Check { case, flaws: Vec::new() };
    if !matches!(case.dimension, 2 | 3) {
        check.flaw(&Key::parse("dimension"), format!("it must be 2 or 3, not {}", case.dimension));
        return check.flaws;
    }
    check.bodies();
    check.boundary();
    check.obstacles();
    check.contact();
    check.time();
    check.figures();
    check.flaws
}

/// Evaluations of the contact in one step; beyond some tens the structure's step bounds the error, so that more is a slip.
const MOST_SUBSTEPS: u32 = 1000;

struct Check<'a> {
    case: &'a Case,
    flaws: Vec<(Key, String)>,
}

impl Check<'_> {
    fn flaw(&mut self, key: &Key, message: String) {
        self.flaws.push((key.clone(), message));
    }

    fn positive(&mut self, key: &Key, value: f64) {
        if !(value.is_finite() && value > 0.0) {
            self.flaw(key, format!("it must be positive, not {value}"));
        }
    }

    fn maybe_positive(&mut self, key: &Key, value: Option<f64>) {
        value.into_iter().for_each(|value| self.positive(key, value));
    }

    fn vector(&mut self, key: &Key, list: Option<&Vec<f64>>) {
        let dimension = self.case.dimension;
        match list {
            Some(list) if list.len() != dimension => {
                self.flaw(key, format!("it must have {dimension} numbers in {dimension}D, not {}", list.len()));
            }
            Some(list) if list.iter().any(|x| !x.is_finite()) => self.flaw(key, "its numbers must be finite".into()),
            _ => {}
        }
    }

    fn bodies(&mut self) {
        let bodies = Key::parse("bodies");
        if self.case.bodies.is_empty() {
            self.flaw(&bodies, "there must be at least one body".into());
        }
        let obstacles = self.case.obstacles.iter().map(|obstacle| &obstacle.name);
        let names: Vec<&String> = self.case.bodies.iter().map(|body| &body.name).chain(obstacles).collect();
        for (index, body) in self.case.bodies.iter().enumerate() {
            let key = bodies.then(index);
            if names.iter().filter(|name| **name == &body.name).count() > 1 {
                self.flaw(&key.then("name"), format!("there is another '{}'", body.name));
            }
            let material = key.then("material");
            self.positive(&material.then("young"), body.material.young);
            self.positive(&material.then("density"), body.material.density);
            let poisson = body.material.poisson;
            if !(poisson > -1.0 && poisson < 0.5) {
                self.flaw(&material.then("poisson"), format!("it must be above −1 and below 0.5, not {poisson}"));
            }
            if body.skew.is_nan() || body.skew.abs() >= 0.5 {
                self.flaw(&key.then("skew"), format!("it must be above −0.5 and below 0.5, not {}", body.skew));
            }
            self.vector(&key.then("initial_velocity"), body.initial_velocity.as_ref());
            self.vector(&key.then("position"), body.position.as_ref());
            if !body.rotation.is_finite() {
                self.flaw(&key.then("rotation"), format!("it must be finite, not {}", body.rotation));
            }
            let before = self.flaws.len();
            self.mesh(&key.then("mesh"), &body.mesh);
            let nodes = body.mesh.node_estimate();
            if self.flaws.len() == before && (nodes.is_nan() || nodes > MOST_NODES) {
                let message = format!("it would have some {nodes:.0e} nodes; at most {MOST_NODES:.0e} are made");
                self.flaw(&key.then("mesh"), message);
            }
        }
    }

    fn body_name(&mut self, key: &Key, name: &str) {
        if self.case.body(name).is_none() {
            let names: Vec<&str> = self.case.bodies.iter().map(|body| body.name.as_str()).collect();
            self.flaw(key, format!("there is no body '{name}'; there are: {}", names.join(", ")));
        }
    }

    fn boundary(&mut self) {
        for (index, support) in self.case.supports.iter().enumerate() {
            let key = Key::parse("supports").then(index);
            let Support { body, place, components, values, then } = support;
            self.body_name(&key.then("body"), body);
            self.place(&key.then("where"), place);
            if components.is_empty() || components.iter().any(|axis| axis.index() >= self.case.dimension) {
                let axes = if self.case.dimension == 2 { "\"x\" and \"y\"" } else { "\"x\", \"y\" and \"z\"" };
                self.flaw(&key.then("components"), format!("it must list some of {axes}"));
            }
            let stages = self.case.load_steps.as_ref().map_or(0, |steps| steps.then.len());
            if !then.is_empty() && (then.len() != stages || then.iter().any(|v| v.len() != components.len())) {
                let message = "it must have one list for every entry of load_steps.then, each with one number for every \
                               component";
                self.flaw(&key.then("then"), message.into());
            }
            if values.as_ref().is_some_and(|values| values.len() != components.len()) {
                self.flaw(&key.then("values"), "it must have one number for every component".into());
            }
        }
        for (index, load) in self.case.loads.iter().enumerate() {
            let key = Key::parse("loads").then(index);
            let Load { body, place, traction, pressure, body_force } = load;
            self.body_name(&key.then("body"), body);
            place.iter().for_each(|place| self.place(&key.then("where"), place));
            self.vector(&key.then("traction"), traction.as_ref());
            self.vector(&key.then("body_force"), body_force.as_ref());
            let given = [traction.is_some(), pressure.is_some(), body_force.is_some()];
            if given.iter().filter(|given| **given).count() != 1 {
                self.flaw(&key, "it must have one of traction, pressure and body_force".into());
            } else if place.is_some() == body_force.is_some() {
                self.flaw(&key, "a traction or a pressure needs 'where'; a body_force acts on all of the body".into());
            }
        }
    }

    fn place(&mut self, key: &Key, place: &Place) {
        let probe = |dimension| match dimension {
            2 => place.holds(&[0.0; 2], &[0.0; 2], &[0.0; 2]),
            _ => place.holds(&[0.0; 3], &[0.0; 3], &[0.0; 3]),
        };
        if probe(self.case.dimension).is_none() {
            let message =
                "it must be one of { side = \"bottom\" }, { axis = \"y\", at = 0.5 } and { min = […], max = […] }";
            self.flaw(key, message.into());
        }
    }

    fn obstacles(&mut self) {
        for (index, obstacle) in self.case.obstacles.iter().enumerate() {
            let key = Key::parse("obstacles").then(index);
            let Obstacle { shape, position, axis, radius, half_height, half_extents, points, .. } = obstacle;
            self.vector(&key.then("position"), position.as_ref());
            self.vector(&key.then("axis"), axis.as_ref());
            self.vector(&key.then("half_extents"), half_extents.as_ref());
            if axis.as_ref().is_some_and(|axis| axis.iter().all(|&x| x == 0.0)) {
                self.flaw(&key.then("axis"), "it must have a direction".into());
            }
            self.maybe_positive(&key.then("radius"), *radius);
            self.maybe_positive(&key.then("half_height"), *half_height);
            half_extents.iter().flatten().for_each(|&extent| self.positive(&key.then("half_extents"), extent));
            if points.as_ref().is_some_and(|points| points.len() < 3) || points.is_some() && self.case.dimension != 2 {
                self.flaw(&key.then("points"), "it must have three corners or more, and be in 2D".into());
            }
            let mut measured = obstacle.measured();
            let read = match self.case.dimension {
                2 => Shape::<2>::read(shape.0, &mut measured).map(drop),
                _ => Shape::<3>::read(shape.0, &mut measured).map(drop),
            };
            if let Err(what) = read {
                self.flaw(&key.then("shape"), format!("it needs {what}, which no case has"));
            }
            for (name, _) in measured.needed.iter().filter(|(_, is_there)| !is_there) {
                self.flaw(&key, format!("this shape needs {name}"));
            }
            let given = [
                ("radius", radius.is_some()),
                ("half_height", half_height.is_some()),
                ("half_extents", half_extents.is_some()),
                ("points", points.is_some()),
            ];
            for (name, _) in given.into_iter().filter(|given| given.1) {
                if !measured.needed.iter().any(|(needed, _)| *needed == name) {
                    self.flaw(&key.then(name), "this shape has no such measure".into());
                }
            }
        }
    }

    fn time(&mut self) {
        let (key, time) = (Key::parse("time"), &self.case.time);
        if let Some(steps) = &self.case.load_steps {
            let key = Key::parse("load_steps");
            self.positive(&key.then("tolerance"), steps.tolerance);
            if steps.tolerance > LARGEST_TOLERANCE {
                let message = format!("it must be at most {LARGEST_TOLERANCE}, not {}", steps.tolerance);
                self.flaw(&key.then("tolerance"), message);
            }
            self.maybe_positive(&key.then("penetration"), steps.penetration);
            if steps.penetration.is_some() && self.case.contact.has_friction() {
                self.flaw(&key.then("penetration"), "multipliers know no friction".into());
            }
            let has_stiffness = matches!(self.case.contact.law, LawName::Fiber | LawName::Depth);
            if steps.penetration.is_some() && (!has_stiffness || self.case.contact.linearised) {
                self.flaw(&key.then("penetration"), "multipliers belong to the laws \"fiber\" and \"depth\"".into());
            }
            if steps.then.contains(&0) {
                self.flaw(&key.then("then"), "its counts must be at least 1".into());
            }
            if steps.count == 0 {
                self.flaw(&key.then("count"), "it must be at least 1".into());
            }
            for (name, &count) in
                std::iter::once(("count", &steps.count)).chain(steps.then.iter().map(|count| ("then", count)))
            {
                if count > MOST_LOAD_STEPS {
                    self.flaw(&key.then(name), format!("it must be at most {MOST_LOAD_STEPS}, not {count}"));
                }
            }
            if !time.is_absent() {
                self.flaw(&key, "a case has load steps or time, not both".into());
            }
            return;
        }
        if time.is_absent() {
            return self.flaw(&key, "it is missing; a case has [time] or [load_steps]".into());
        }
        self.positive(&key.then("end"), time.end);
        self.maybe_positive(&key.then("step"), time.step);
        self.maybe_positive(&key.then("damping"), time.damping);
        if !(1..=MOST_SUBSTEPS).contains(&time.contact_substeps) {
            let message = format!("it must be 1 to {MOST_SUBSTEPS}, not {}", time.contact_substeps);
            self.flaw(&key.then("contact_substeps"), message);
        }
        if time.step.is_some() == time.fraction.is_some() {
            self.flaw(&key, "it must have one of step, in s, and fraction, of the largest stable step".into());
        }
        if let Some(fraction) = time.fraction
            && !(fraction > 0.0 && fraction <= 1.0)
        {
            self.flaw(&key.then("fraction"), format!("it must be above 0 and at most 1, not {fraction}"));
        }
        if time.step.is_some_and(|step| step > time.end) {
            self.flaw(&key.then("step"), format!("it must be at most end = {}", time.end));
        }
        if time.step.is_some_and(|step| time.end / step > MOST_STEPS) {
            self.flaw(&key.then("end"), format!("it must be at most {MOST_STEPS:.0e} steps away, not {}", time.end));
        }
    }

    fn figures(&mut self) {
        let figures = &self.case.figures;
        figures.body.iter().for_each(|body| self.body_name(&Key::parse("figures.body"), body));
        if figures.kind.is_static().is_some_and(|is_static| is_static != self.case.load_steps.is_some()) {
            let message = "these figures are taken from an equilibrium, with [load_steps], if they are none of \"wall\", \
                 \"impact\" and \"stop\", and only then; \"forces\" suits both";
            self.flaw(&Key::parse("figures.kind"), message.into());
        }
        let Some(body) = self.case.bodies.get(self.case.figured()) else { return };
        if figures.kind.is_static() == Some(false) && !body.moves() {
            self.flaw(&Key::parse("figures.body"), format!("'{}' must move at the start", body.name));
        }
        if figures.kind == FigureKind::Driven && self.case.driver().is_none() {
            let message = format!("no support moves '{}' in the first stage; \"forces\" suits any case", body.name);
            self.flaw(&Key::parse("figures.kind"), message);
        }
        if figures.kind == FigureKind::Patch && self.case.loads.iter().all(|load| load.pressure.is_none()) {
            let message = "these figures compare with the pressure of a load, and no load is a pressure".to_owned();
            self.flaw(&Key::parse("figures.kind"), message);
        }
        if figures.kind == FigureKind::Hertz && !matches!(body.mesh, MeshSource::GradedHalfDisc { .. }) {
            let message = format!("these figures need a \"graded-half-disc\", and '{}' is none", body.name);
            self.flaw(&Key::parse("figures.kind"), message);
        }
        if figures.copies == 0 {
            self.flaw(&Key::parse("figures.copies"), "it must be at least 1".into());
        }
        if figures.profile.iter().flatten().any(|x| !x.is_finite()) {
            self.flaw(&Key::parse("figures.profile"), "its numbers must be finite".into());
        }
        let known = figures.kind.keys();
        for (index, expected) in self.case.expected.iter().enumerate() {
            let key = Key::parse("expected").then(index);
            if !known.contains(&expected.figure.as_str()) {
                let message = format!("there is no figure '{}' here; there are: {}", expected.figure, known.join(", "));
                self.flaw(&key.then("figure"), message);
            }
            if !expected.value.is_finite() {
                self.flaw(&key.then("value"), "it must be finite".into());
            }
            self.maybe_positive(&key.then("relative"), expected.relative);
            self.maybe_positive(&key.then("absolute"), expected.absolute);
            if expected.relative.is_some() && expected.absolute.is_some() {
                self.flaw(&key.then("absolute"), "it cannot go together with relative".into());
            }
        }
    }
}
