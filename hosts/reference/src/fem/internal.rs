//! Strain energy, internal force and products with the stiffness.

use super::Model;
use super::assembly::assemble;
use super::elements::{Cell, Elements};
use super::response::Response;
use super::rings;
use super::tensor::Tensor;
use rayon::ThreadPool;

impl<const D: usize> Model<D> {
    /// Writes the internal force of every node, ∂E/∂u, to `force` and returns the strain energy E, in J (per unit
    /// thickness in 2D). Both arrays are `[node_count, D]`.
    ///
    /// The energy is infinite where a neo-Hookean element is inverted (J ≤ 0 at a Gauss point).
    ///
    /// # Panics
    /// If an array has another length.
    pub fn internal(&self, displacement: &[[f64; D]], force: &mut [[f64; D]]) -> f64 {
        assert_eq!((displacement.len(), force.len()), (self.node_count(), self.node_count()));
        force.fill([0.0; D]);
        let pool = self.pool.as_ref();
        let energy = |elements: &Elements<D>| match elements.cell_type.node_count() {
            3 => internal::<D, 3>(elements, pool, displacement, force),
            4 => internal::<D, 4>(elements, pool, displacement, force),
            6 => internal::<D, 6>(elements, pool, displacement, force),
            8 => internal::<D, 8>(elements, pool, displacement, force),
            9 => internal::<D, 9>(elements, pool, displacement, force),
            15 => internal::<D, 15>(elements, pool, displacement, force),
            10 => internal::<D, 10>(elements, pool, displacement, force),
            20 => internal::<D, 20>(elements, pool, displacement, force),
            _ => internal::<D, 27>(elements, pool, displacement, force),
        };
        self.elements.iter().map(energy).sum()
    }

    /// Writes to `product` the stiffness at `displacement` times `direction`: the derivative of the internal force.
    ///
    /// # Panics
    /// If an array has another length than `[node_count, D]`.
    pub fn stiffness_product(&self, displacement: &[[f64; D]], direction: &[[f64; D]], product: &mut [[f64; D]]) {
        let count = self.node_count();
        assert_eq!([displacement.len(), direction.len(), product.len()], [count; 3]);
        product.fill([0.0; D]);
        for elements in &self.elements {
            match elements.cell_type.node_count() {
                3 => stiffness_product::<D, 3>(elements, self.pool.as_ref(), displacement, direction, product),
                4 => stiffness_product::<D, 4>(elements, self.pool.as_ref(), displacement, direction, product),
                6 => stiffness_product::<D, 6>(elements, self.pool.as_ref(), displacement, direction, product),
                8 => stiffness_product::<D, 8>(elements, self.pool.as_ref(), displacement, direction, product),
                9 => stiffness_product::<D, 9>(elements, self.pool.as_ref(), displacement, direction, product),
                15 => stiffness_product::<D, 15>(elements, self.pool.as_ref(), displacement, direction, product),
                10 => stiffness_product::<D, 10>(elements, self.pool.as_ref(), displacement, direction, product),
                20 => stiffness_product::<D, 20>(elements, self.pool.as_ref(), displacement, direction, product),
                _ => stiffness_product::<D, 27>(elements, self.pool.as_ref(), displacement, direction, product),
            }
        }
    }
}

fn internal<const D: usize, const N: usize>(
    elements: &Elements<D>,
    pool: Option<&ThreadPool>,
    displacement: &[[f64; D]],
    force: &mut [[f64; D]],
) -> f64 {
    let response = Response::new(&elements.material);
    assemble::<D, N>(elements, pool, force, |number, f| {
        let cell = elements.cell::<N>(number);
        let Cell { nodes, gradients, volumes, .. } = cell;
        let u = nodes.map(|node| displacement[node as usize]);
        let mut energy = 0.0;
        if elements.is_ring() {
            rings::add_forces(&cell, f, |gradients, hoops, volume| {
                let (stress, density) = response.stress(&rings::gradient(&u, gradients, hoops));
                energy += volume * density;
                stress
            });
            return energy;
        }
        let of_modes = elements.modes.as_ref().map(|modes| (modes, modes.amplitudes(number, &u)));
        for (place, (gradients, &volume)) in gradients.iter().zip(volumes).enumerate() {
            let mut h = gradient(&u, gradients);
            if let Some((modes, amplitudes)) = &of_modes {
                modes.add(number * volumes.len() + place, amplitudes, &mut h);
            }
            let (stress, density) = response.stress(&h);
            energy += volume * density;
            add_divergence(&stress, gradients, volume, f);
        }
        energy
    })
}

fn stiffness_product<const D: usize, const N: usize>(
    elements: &Elements<D>,
    pool: Option<&ThreadPool>,
    displacement: &[[f64; D]],
    direction: &[[f64; D]],
    product: &mut [[f64; D]],
) {
    let response = Response::new(&elements.material);
    assemble::<D, N>(elements, pool, product, |number, f| {
        let cell = elements.cell::<N>(number);
        let Cell { nodes, gradients, volumes, .. } = cell;
        let u = nodes.map(|node| displacement[node as usize]);
        let du = nodes.map(|node| direction[node as usize]);
        if elements.is_ring() {
            rings::add_forces(&cell, f, |gradients, hoops, _| {
                let [h, dh] = [&u, &du].map(|u| rings::gradient(u, gradients, hoops));
                response.stress_derivative(&h, &dh)
            });
            return 0.0;
        }
        let of_modes = elements.modes.as_ref().map(|modes| (modes, modes.amplitudes(number, &du)));
        for (place, (gradients, &volume)) in gradients.iter().zip(volumes).enumerate() {
            let mut dh = gradient(&du, gradients);
            if let Some((modes, amplitudes)) = &of_modes {
                modes.add(number * volumes.len() + place, amplitudes, &mut dh);
            }
            let stress = response.stress_derivative(&gradient(&u, gradients), &dh);
            add_divergence(&stress, gradients, volume, f);
        }
        0.0
    });
}

/// H = Σ u_a ⊗ ∇N_a.
#[inline(always)]
fn gradient<const D: usize, const N: usize>(u: &[[f64; D]; N], gradients: &[[f64; D]; N]) -> Tensor<D> {
    let mut h = [[0.0; D]; D];
    for node in 0..N {
        for i in 0..D {
            (0..D).for_each(|j| h[i][j] += u[node][i] * gradients[node][j]);
        }
    }
    h
}

/// f_a += P ∇N_a dV.
#[inline(always)]
fn add_divergence<const D: usize, const N: usize>(
    stress: &Tensor<D>,
    gradients: &[[f64; D]; N],
    volume: f64,
    f: &mut [[f64; D]; N],
) {
    for i in 0..D {
        let row = stress[i].map(|p| volume * p);
        for node in 0..N {
            (0..D).for_each(|j| f[node][i] += row[j] * gradients[node][j]);
        }
    }
}
