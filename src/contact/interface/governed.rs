//! What hosts ask of interfaces that follow a law of theirs.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::contact::governed::{LawPoint, OwnLaw};
use crate::contact::partners::{Interface, PairOptions};
use crate::interfaces::{InterfaceLaw, LawFields};
use crate::overlap::Partner;
use std::sync::Arc;

impl<const D: usize> Contact<D> {
    /// Sets the options of a pair as [`Self::set_pair_options`] does, whose interface is [`Interface::Law`], with the law. Its history begins
    /// with zeros, unless it is the very law that the pair has with the same points.
    ///
    /// # Errors
    /// Those of [`Self::set_pair_options`]; [`Error::Unsupported`] for another interface. What was set before then stays.
    #[inline(never)]
    pub fn set_law_pair(
        &mut self,
        partners: [Partner; 2],
        options: PairOptions,
        law: Arc<dyn InterfaceLaw>,
    ) -> Result<(), Error> {
        if !matches!(options.interface, Interface::Law { .. }) {
            return Err(Error::Unsupported { what: "your own law with another interface than 'law'" });
        }
        changes::options::set_pair(self, partners, Some(options), (Some(&OwnLaw::new(law)), None))
    }

    /// Sets fields that laws of the host are asked with at their points, such as a temperature: `count` numbers for every row of the coordinates,
    /// all of a row together. They stay until others are set; none: no fields.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`] for what is not finite; the old ones then stay.
    #[inline(never)]
    pub fn set_law_fields(&mut self, count: usize, values: &[f64]) -> Result<(), Error> {
        let rows = self.mesh.surface.unknown_count();
        let expected = rows.saturating_mul(count);
        if values.len() != expected {
            return Err(Error::Length { array: "values", expected, found: values.len() });
        }
        if let Some(entry) = values.iter().position(|x| !x.is_finite()) {
            return Err(Error::BadEntry { array: "values", entry, value: values[entry] });
        }
        let mut fields = LawFields { count, values: Vec::new() };
        for field in 0..count {
            let column: Vec<[f64; D]> = values.chunks(count).map(|row| [row[field]; D]).collect();
            let points = self.mesh.surface.mesh_points(&column)?;
            fields.values.resize(points.len() * count, 0.0);
            points.iter().enumerate().for_each(|(point, value)| fields.values[point * count + field] = value[0]);
        }
        self.history.law_fields = fields;
        self.state.forget_found();
        Ok(())
    }

    /// All points of interfaces by laws of the host at `coords`, by pair, in the order in which the laws are asked.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`]; [`Error::Untied`] where one was found on another mesh without deformation, and is not
    /// on this one; [`Error::InterfaceLaw`].
    #[inline(never)]
    pub fn law_points(&self, coords: &[[f64; D]]) -> Result<Vec<LawPoint<D>>, Error> {
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let mut found = Vec::new();
        for (held, at, _) in self.at_points(&points, |at| self.governed.there(at))? {
            let history = at.answer.history.len() / held.points.points.len();
            found.extend(held.points.points.iter().enumerate().map(|(number, point)| LawPoint {
                bodies: held.points.bodies,
                position: std::array::from_fn(|axis| at.positions[number * D + axis]),
                area: point.measure,
                axes: at.axes(number),
                jump: at.jump(number),
                traction: at.traction(number),
                stored: at.answer.stored[number],
                dissipated: at.answer.dissipated[number],
                history: at.answer.history[number * history..][..history].to_vec(),
            }));
        }
        Ok(found)
    }

    /// The history of all these points after the steps that were accepted ([`Self::commit_step`]), one point after the other, in the order of
    /// [`Self::law_points`]. With the coordinates it is all that a restart needs of them.
    ///
    /// # Errors
    /// [`Error::Untied`] as [`Self::law_points`].
    #[inline(never)]
    pub fn law_history(&self) -> Result<Vec<f64>, Error> {
        self.governed.list(&self.history.of_laws)
    }

    /// Sets it.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`] for what is not finite, [`Error::Untied`]. Nothing has then changed.
    #[inline(never)]
    pub fn set_law_history(&mut self, history: &[f64]) -> Result<(), Error> {
        self.history.of_laws = self.governed.of_list(history)?;
        self.state.forget_found();
        Ok(())
    }
}
