//! Memory of one evaluation: at most 300 bytes per facet, plus 100 per crossing that bounds the overlap; under a local law
//! 200, since spans are kept with what is at their ends until their pressures are known.

use fmc_contact::{Bodies, Contact, EnergyLaw, Estimator, FiberOptions, Options, Resolution, Surface};
use fmc_shapes::icosphere;
use peak_alloc::PeakAlloc;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

#[test]
fn memory_is_bounded_by_facets_and_crossings() {
    let ball = icosphere(1.0, 5);
    let mut both = ball.clone();
    both.append(&ball.rotated([1.0, 2.0, 3.0], 0.7).translated([0.3, 0.4, 1.884_807_682_498_071_6]));
    let facets = both.facets();
    let ids: Vec<i64> = (0..facets.len()).map(|f| i64::from(f >= facets.len() / 2)).collect();
    let by_spacing = [(1.7e-2, 1), (4.25e-3, 1), (1.1e-3, 1), (1.1e-3, 2)];
    let laws = [(EnergyLaw::volume(1.0), 100), (EnergyLaw::fiber(1.0), 200)];
    for ((law, of_crossing), (spacing, threads)) in laws.into_iter().flat_map(|law| by_spacing.map(|s| (law, s))) {
        let before = HEAP.current_usage();
        let surface = Surface::from_facets(&both.coords, &facets, Bodies::Ids(&ids)).expect("two closed surfaces");
        let resolution = Resolution::Spacing(spacing);
        let estimator = Estimator::Fibers(FiberOptions { resolution, ..FiberOptions::default() });
        let options = Options { estimator, threads, ..Options::new(law) };
        let contact = Contact::new(surface, options).expect("valid options");
        let kept = HEAP.current_usage() - before;
        HEAP.reset_peak_usage();
        let crossings = contact.evaluate(&both.coords).expect("valid coordinates").crossing_count;
        let peak = HEAP.peak_usage() - before;
        let allowed = 300 * facets.len() + of_crossing * crossings;
        println!(
            "{law:?}, {crossings} crossings, {threads} threads: {kept} B kept, {peak} at the peak, {allowed} allowed"
        );
        assert!(peak <= allowed, "{law:?}: {peak} bytes with {} facets and {crossings} crossings", facets.len());
    }
}
