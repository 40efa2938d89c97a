//! What is made for one N, looked up where N is a parameter: it is compiled once, where it is named.

use std::any::Any;

/// What there is for the plane and what there is for space, as it is for the N of T; None for other N.
pub(super) fn of_dimension<T: Copy + 'static>(
    n: usize,
    plane: impl Any,
    space: impl Any,
) -> Option<T> {
    let found: &dyn Any = match n {
        2 => &plane,
        3 => &space,
        _ => return None,
    };
    let found = found.downcast_ref::<T>();
    Some(*found.expect("each is for its N"))
}
