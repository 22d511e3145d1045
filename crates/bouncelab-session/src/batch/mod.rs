//! Recordings that an engine analyses on a cluster.
//!
//! | module | what it does |
//! |---|---|
//! | `row` | the row of one recording |
//! | `kernel` | from a recording to its row |
//! | `kept` | the rows that an engine wrote as Parquet, as the results of a session |
//! | `texts` | columns of texts in Parquet files, damaged ones too |

mod kept;
mod kernel;
mod row;
mod texts;

pub use kept::Batch;
pub use kernel::{Given, Kernel, KernelOptions};
pub use row::{Failure, FailureCode, Known, Row, RowTables};
