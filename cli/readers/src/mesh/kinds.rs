//! The elements of Gmsh: which are read, of which order, which are refused.

/// What is to be done with an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A point, line, triangle or tetrahedron with all the nodes of its order.
    Simplex {
        /// Its dimension.
        dimension: usize,
        /// k: 1 for straight ones.
        order: usize,
    },
    /// No such simplex, by name.
    Refused(&'static str),
}

const fn simplex(dimension: usize, order: usize) -> Kind {
    Kind::Simplex { dimension, order }
}

/// The element with this number in Gmsh's list.
pub fn kind(number: i32) -> Option<Kind> {
    Some(match number {
        1 => simplex(1, 1),
        2 => simplex(2, 1),
        3 => Kind::Refused("quadrangle"),
        4 => simplex(3, 1),
        5 => Kind::Refused("hexahedron"),
        6 => Kind::Refused("prism"),
        7 => Kind::Refused("pyramid"),
        8 => simplex(1, 2),
        9 => simplex(2, 2),
        10 => Kind::Refused("9-node quadrangle"),
        11 => simplex(3, 2),
        12 => Kind::Refused("27-node hexahedron"),
        13 => Kind::Refused("18-node prism"),
        14 => Kind::Refused("14-node pyramid"),
        15 => simplex(0, 1),
        16 => Kind::Refused("8-node quadrangle"),
        17 => Kind::Refused("20-node hexahedron"),
        18 => Kind::Refused("15-node prism"),
        19 => Kind::Refused("13-node pyramid"),
        20 | 22 | 24 => Kind::Refused("triangle without inner nodes (serendipity)"),
        21 => simplex(2, 3),
        23 => simplex(2, 4),
        25 => Kind::Refused("triangle of order 5"),
        26 => simplex(1, 3),
        27 => simplex(1, 4),
        28 => simplex(1, 5),
        29 => simplex(3, 3),
        30 => simplex(3, 4),
        31 => Kind::Refused("tetrahedron of order 5"),
        92 | 93 => Kind::Refused("hexahedron of higher order"),
        _ => return None,
    })
}
