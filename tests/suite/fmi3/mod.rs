//! The functions of FMI 3.0 under right and wrong use, and that they give what those of FMI 2.0
//! give.
#![allow(unsafe_code)]

mod adjoint;
mod any_order;
mod arrays;
mod derivatives;
mod exchange;
mod life;
mod memory;
mod same_forces;
mod states;
