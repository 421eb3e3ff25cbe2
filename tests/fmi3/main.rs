//! The functions of FMI 3.0 under right and wrong use, and that they give what those of FMI 2.0 give.
#![allow(unsafe_code)]

#[path = "../allocations/mod.rs"]
mod allocations;
mod any_order;
mod arrays;
#[path = "../common/mod.rs"]
mod common;
mod derivatives;
mod exchange;
#[path = "../host/mod.rs"]
mod host;
#[path = "../host3/mod.rs"]
mod host3;
mod life;
mod memory;
mod same_forces;
mod states;
