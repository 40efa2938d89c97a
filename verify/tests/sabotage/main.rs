//! Break one formula of the library, and the catalogue names the claims that it broke.
//!
//! The claims run through the library's own generic code with one method of `Formulas` overridden.

mod broken;
mod mesh;
mod pointwise;
