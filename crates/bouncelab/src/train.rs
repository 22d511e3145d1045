//! Candidates to trains: which are the impacts of one drop.
