//! The whole of a file.

use super::amplitude::Amplitude;
use super::elements::{ElementRow, is_ring, solved};
use super::equation::EquationRow;
use super::general::GeneralRow;
use super::interaction::{Interaction, PairRow, TieRow};
use super::material::MaterialRow;
use super::mpc::Mpc;
use super::names::{Kind, Names};
use super::note::Note;
use super::output::{instead, sampled, unused};
use super::rigid::{RigidKind, RigidRow};
use super::rigid_elements::RigidElements;
use super::rows::{Rows, element_rows, take_rows};
use super::scope::Scope;
use super::section::SectionRow;
use super::step::Step;
use super::surface::Surfaces;
use super::transform::TransformRow;
use super::words::only;
use crate::Fault;
use fmc_mesh_io::inp::{Expanded, Keyword, Lines, fields};
use fmc_mesh_io::{Kind as Filled, Mesh};
use std::collections::BTreeMap;

/// What a file says.
pub struct Deck {
    /// Nodes and elements.
    pub mesh: Mesh,
    /// What is taken in another sense than the file may mean.
    pub notes: Vec<Note>,
    pub(crate) names: Names,
    pub(crate) surfaces: Surfaces,
    pub(crate) materials: BTreeMap<String, MaterialRow>,
    pub(crate) sections: Vec<SectionRow>,
    pub(crate) amplitudes: BTreeMap<String, Amplitude>,
    pub(crate) interactions: BTreeMap<String, Interaction>,
    pub(crate) pairs: Vec<PairRow>,
    pub(crate) ties: Vec<TieRow>,
    pub(crate) rigid: Vec<RigidRow>,
    pub(crate) equations: Vec<EquationRow>,
    pub(crate) transforms: Vec<TransformRow>,
    /// Sets of nodes whose reactions are asked for, with the line.
    pub(crate) reactions: Vec<(String, usize)>,
    /// What holds from the start.
    pub(crate) initial: Step,
    pub(crate) steps: Vec<Step>,
    /// Of every element: its line, and its type as the file has it.
    pub(crate) elements: Vec<ElementRow>,
    input: Expanded,
}

/// What a keyword may belong to that stands before it.
#[derive(Default)]
struct Open {
    scope: Option<Scope>,
    material: Option<String>,
    interaction: Option<String>,
    is_in_step: bool,
    /// Requests of output, with the lines where they come first.
    requests: Vec<(String, usize)>,
    elements: Vec<Rows>,
    rigid: Vec<RigidElements>,
    general: Option<GeneralRow>,
}

impl Deck {
    /// A fault as editors know it: file, line and sentence.
    pub fn located(&self, fault: &Fault) -> String {
        format!("{}: {}", self.input.source(fault.line), fault.message)
    }

    /// The line of a step, from 1.
    pub fn step_line(&self, number: usize) -> usize {
        self.steps.get(number.wrapping_sub(1)).map_or(1, |step| step.line)
    }

    /// Dimension of the space that the bodies fill.
    ///
    /// # Errors
    /// If elements of the plane do not lie in one.
    pub fn dimension(&self) -> Result<usize, Fault> {
        match self.mesh.kind() {
            Filled::Flat => Ok(2),
            Filled::Solid => Ok(3),
            Filled::Surface => {
                let line = self.elements.first().map_or(1, |row| row.line);
                Err(Fault::new(line, "elements of the plane do not lie in a plane z = const"))
            }
        }
    }

    /// Whether its elements are sections (r, z) of bodies of revolution.
    pub fn is_axisymmetric(&self) -> bool {
        self.elements.iter().any(|row| is_ring(&row.kind))
    }

    /// Of a mesh, without its keywords.
    pub(super) fn empty(mesh: Mesh, input: Expanded) -> Self {
        Self {
            names: Names::new(&mesh),
            mesh,
            notes: Vec::new(),
            surfaces: Surfaces::default(),
            materials: BTreeMap::new(),
            sections: Vec::new(),
            amplitudes: BTreeMap::new(),
            interactions: BTreeMap::new(),
            pairs: Vec::new(),
            ties: Vec::new(),
            rigid: Vec::new(),
            equations: Vec::new(),
            transforms: Vec::new(),
            reactions: Vec::new(),
            initial: Step::empty(1),
            steps: Vec::new(),
            elements: Vec::new(),
            input,
        }
    }

    /// Takes all keywords, and returns the rigid elements, which the mesh does not have.
    pub(super) fn take(&mut self, text: &str) -> Result<Vec<RigidElements>, Fault> {
        let mut lines = Lines::new(text);
        let mut open = Open::default();
        loop {
            if let Some((line, text)) = lines.data() {
                return Err(Fault::new(line, format!("'{text}' belongs to no keyword")));
            }
            let Some(keyword) = lines.keyword() else { break };
            self.take_keyword(&keyword, &mut lines, &mut open)?;
        }
        self.pairs.extend(open.general.take().map(GeneralRow::pairs).transpose()?.into_iter().flatten());
        let last = text.lines().count();
        if open.is_in_step {
            return Err(Fault::new(last, "the file ends within a *STEP"));
        }
        if self.steps.is_empty() {
            return Err(Fault::new(last, "there is no *STEP: nothing is solved"));
        }
        if let Some(row) = self.rigid.iter().find(|row| row.kind == RigidKind::Unknown) {
            return Err(Fault::new(row.line, "this *COUPLING has neither *KINEMATIC nor *DISTRIBUTING"));
        }
        for (name, line) in &open.requests {
            let said = unused(name).unwrap_or_default();
            self.notes.push(Note::new(*line, format!("*{name}: {said}")));
        }
        self.elements = element_rows(&self.names, self.mesh.cell_count(), &open.elements);
        Ok(open.rigid)
    }

    fn take_keyword(&mut self, keyword: &Keyword, lines: &mut Lines, open: &mut Open) -> Result<(), Fault> {
        if let Some(scope) = open.scope.clone().unwrap_or(Scope::Model).after(keyword)? {
            if matches!(scope, Scope::Instance(_)) {
                self.names.instance(keyword);
                // How it is placed the mesh has read.
                while lines.data().is_some() {}
            }
            open.scope = Some(scope);
            return Ok(());
        }
        let scope = open.scope.clone().unwrap_or(Scope::Model);
        let name = keyword.name.as_str();
        if let Some(material) = open.material.as_ref().and_then(|name| self.materials.get_mut(name)) {
            if material.read(keyword, lines, &mut self.notes)? {
                return Ok(());
            }
            open.material = None;
        }
        if let Some(interaction) = open.interaction.as_ref().and_then(|name| self.interactions.get_mut(name)) {
            if interaction.read(keyword, lines, &mut self.notes)? {
                return Ok(());
            }
            open.interaction = None;
        }
        if unused(name).is_some() {
            if name == "RESTART" && keyword.value("READ").is_some() {
                return Err(Fault::new(keyword.line, "*RESTART, READ is not known; known is WRITE"));
            }
            let sampled = sampled(keyword).filter(|_| !open.requests.iter().any(|(known, _)| *known == "TIME POINTS"));
            if let Some(parameter) = sampled {
                open.requests.push(("TIME POINTS".to_owned(), keyword.line));
                self.notes.push(Note::new(
                    keyword.line,
                    format!("*{name}, {parameter}: {}", unused("TIME POINTS").unwrap_or_default()),
                ));
            }
            let mut is_reaction = false;
            while let Some((_, text)) = lines.data() {
                is_reaction |= fields(text).any(|field| field.eq_ignore_ascii_case("RF"));
            }
            if let (true, "NODE PRINT", Some(set)) = (is_reaction, name, keyword.value("NSET")) {
                if !self.reactions.iter().any(|(known, _)| known.eq_ignore_ascii_case(set)) {
                    self.reactions.push((set.to_owned(), keyword.line));
                }
                return Ok(());
            }
            if !open.requests.iter().any(|(known, _)| known == name) {
                open.requests.push((name.to_owned(), keyword.line));
            }
            return Ok(());
        }
        match name {
            "HEADING" => while lines.data().is_some() {},
            "INCLUDE" if keyword.parameters.iter().any(|(name, _)| name != "INPUT") => only(keyword, &["INPUT"])?,
            // Its text stands in its place.
            "INCLUDE" => {}
            "NODE" => drop(take_rows(&mut self.names, (Kind::Node, 1), keyword, &scope, lines)?),
            "ELEMENT" => {
                if let Some(rows) = RigidElements::read(keyword, &scope, lines, &mut self.names)? {
                    open.rigid.push(rows);
                    return Ok(());
                }
                let kind = keyword.required("TYPE")?;
                let cell_type = solved(keyword.line, kind)?;
                if self.mesh.cells().next().is_some_and(|(first, ..)| first.dimension() != cell_type.dimension()) {
                    return Err(Fault::new(keyword.line, "there are 2D and 3D elements"));
                }
                let other = open.elements.iter().find(|rows| is_ring(&rows.kind) != is_ring(kind));
                if let Some(other) = other.filter(|_| cell_type.dimension() == 2) {
                    let message =
                        format!("elements of type {kind} together with {}: axisymmetric and plane bodies", other.kind);
                    return Err(Fault::new(keyword.line, message));
                }
                let labels =
                    take_rows(&mut self.names, (Kind::Cell, cell_type.node_count() + 1), keyword, &scope, lines)?;
                open.elements.push(Rows { scope, line: keyword.line, kind: kind.to_uppercase(), labels });
            }
            "NSET" => self.names.read(Kind::Node, keyword, &scope, lines)?,
            "ELSET" => self.names.read(Kind::Cell, keyword, &scope, lines)?,
            "SURFACE" => self.surfaces.read(keyword, &scope, lines)?,
            "SOLID SECTION" => self.sections.push(SectionRow::read(keyword, &scope, lines, &mut self.notes)?),
            "MATERIAL" => {
                let material = MaterialRow::begin(keyword)?;
                let name = material.name.to_uppercase();
                open.material = Some(name.clone());
                if self.materials.insert(name, material).is_some() {
                    return Err(Fault::new(keyword.line, "this material is there twice"));
                }
            }
            "AMPLITUDE" => {
                let name = keyword.required("NAME")?.to_uppercase();
                let amplitude = Amplitude::read(keyword, lines)?;
                if self.amplitudes.insert(name, amplitude).is_some() {
                    return Err(Fault::new(keyword.line, "this amplitude is there twice"));
                }
            }
            "SURFACE INTERACTION" => {
                let interaction = Interaction::begin(keyword, lines)?;
                open.interaction = Some(interaction.name.clone());
                if self.interactions.insert(interaction.name.clone(), interaction).is_some() {
                    return Err(Fault::new(keyword.line, "this *SURFACE INTERACTION is there twice"));
                }
            }
            "CONTACT PAIR" => self.pairs.extend(PairRow::read(keyword, lines, &mut self.notes)?),
            "CONTACT" => {
                if let Some(first) = open.general.replace(GeneralRow::begin(keyword)?) {
                    let message = format!("*CONTACT is there already, in line {}", first.line);
                    return Err(Fault::new(keyword.line, message));
                }
            }
            "CONTACT INCLUSIONS" | "CONTACT PROPERTY ASSIGNMENT" => match &mut open.general {
                Some(row) => row.read(keyword, lines)?,
                None => return Err(Fault::new(keyword.line, format!("*{name} stands behind no *CONTACT"))),
            },
            "TIE" => self.ties.extend(TieRow::read(keyword, lines, &mut self.notes)?),
            "RIGID BODY" if !open.is_in_step => self.rigid.push(RigidRow::read_body(keyword, &scope, lines)?),
            "KINEMATIC COUPLING" if !open.is_in_step => self.rigid.extend(RigidRow::read_old(keyword, &scope, lines)?),
            "COUPLING" if !open.is_in_step => self.rigid.push(RigidRow::begin_coupling(keyword, &scope, lines)?),
            "TRANSFORM" if !open.is_in_step => self.transforms.push(TransformRow::read(keyword, &scope, lines)?),
            "EQUATION" if !open.is_in_step => self.equations.extend(EquationRow::read(keyword, &scope, lines)?),
            "MPC" if !open.is_in_step => {
                let dimension = self.mesh.cells().next().map_or(3, |(cell_type, ..)| cell_type.dimension());
                let Mpc { equations, rigid } = Mpc::read(keyword, &scope, lines, dimension)?;
                self.equations.extend(equations);
                self.rigid.extend(rigid);
            }
            "KINEMATIC" | "DISTRIBUTING" => match self.rigid.last_mut().filter(|row| row.keyword == "*COUPLING") {
                Some(row) => row.read_kind(keyword, lines)?,
                None => return Err(Fault::new(keyword.line, format!("*{name} stands behind no *COUPLING"))),
            },
            _ => self.take_step_keyword(keyword, lines, open)?,
        }
        Ok(())
    }

    fn take_step_keyword(&mut self, keyword: &Keyword, lines: &mut Lines, open: &mut Open) -> Result<(), Fault> {
        let line = keyword.line;
        let step = match self.steps.last_mut() {
            Some(step) if open.is_in_step => Some(step),
            _ => None,
        };
        match (keyword.name.as_str(), step) {
            ("STEP", None) => {
                let step = Step::begin(keyword, lines, &mut self.notes)?;
                open.is_in_step = true;
                self.steps.push(step);
            }
            ("END STEP", Some(step)) => {
                only(keyword, &[])?;
                open.is_in_step = false;
                if !step.is_static {
                    return Err(Fault::new(step.line, "this step has no *STATIC"));
                }
            }
            ("STATIC", Some(step)) => step.read_static(keyword, lines, &mut self.notes)?,
            ("BOUNDARY", Some(step)) => step.read_boundary(keyword, lines)?,
            ("BOUNDARY", None) => self.initial.read_boundary(keyword, lines)?,
            ("CLOAD", Some(step)) => step.read_forces(keyword, lines)?,
            ("DLOAD" | "DSLOAD", Some(step)) => step.read_spread(keyword, lines)?,
            ("STEP" | "END STEP" | "STATIC" | "CLOAD" | "DLOAD" | "DSLOAD", _) => {
                return Err(Fault::new(line, format!("*{} stands where none can be", keyword.name)));
            }
            (name, _) => {
                let instead = instead(name).map_or(String::new(), |text| format!(": {text}"));
                return Err(Fault::new(line, format!("*{name} is not known{instead}")));
            }
        }
        Ok(())
    }
}
