//! `fmc report`: every example of the paper on one page.
//!
//! ```text
//! cases/report.toml --> plan --> job --> carry_out, kernel --> record --> page --> OUT/report.html
//!                                               |                ^
//!                                               +--> drawing ----+   pictures
//! ```
//!
//! A job is one run: a kernel check, or a case or variant. Each leaves its record and its pictures in a folder of its own,
//! `OUT/runs/JOB`; a record whose [`stamp::Stamp`] is still right is not computed again, so that a report that was
//! interrupted goes on where it stopped. The page is made from the records alone and holds everything it shows.

mod carry_out;
mod drawing;
mod job;
mod kernel;
mod page;
mod plan;
mod quantity;
mod record;
mod setting;
mod stamp;

pub use carry_out::carry_out;
pub use job::{Example, Size, examples};
pub use page::write;
pub use plan::Plan;
pub use record::{Outcome, Record};
pub use setting::Setting;
pub use stamp::{Stamp, program};
