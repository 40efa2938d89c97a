//! The elements of Gmsh: which are cells, which are passed over, which are refused.

/// What is to be done with an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A triangle.
    Triangle,
    /// A tetrahedron.
    Tetrahedron,
    /// A point: kept for the group that it may be of.
    Point,
    /// A line with straight edges: likewise.
    Line,
    /// A line of higher order, with so many nodes: not needed.
    Passed(usize),
    /// No simplex with straight edges, by name.
    Refused(&'static str),
}

/// The element with this number in Gmsh's list.
pub fn kind(number: i32) -> Option<Kind> {
    Some(match number {
        1 => Kind::Line,
        2 => Kind::Triangle,
        3 => Kind::Refused("quadrangle"),
        4 => Kind::Tetrahedron,
        5 => Kind::Refused("hexahedron"),
        6 => Kind::Refused("prism"),
        7 => Kind::Refused("pyramid"),
        8 => Kind::Passed(3),
        9 => Kind::Refused("6-node triangle"),
        10 => Kind::Refused("9-node quadrangle"),
        11 => Kind::Refused("10-node tetrahedron"),
        12 => Kind::Refused("27-node hexahedron"),
        13 => Kind::Refused("18-node prism"),
        14 => Kind::Refused("14-node pyramid"),
        15 => Kind::Point,
        16 => Kind::Refused("8-node quadrangle"),
        17 => Kind::Refused("20-node hexahedron"),
        18 => Kind::Refused("15-node prism"),
        19 => Kind::Refused("13-node pyramid"),
        20..=25 => Kind::Refused("triangle of higher order"),
        26 => Kind::Passed(4),
        27 => Kind::Passed(5),
        28 => Kind::Passed(6),
        29..=31 => Kind::Refused("tetrahedron of higher order"),
        92 | 93 => Kind::Refused("hexahedron of higher order"),
        _ => return None,
    })
}

impl Kind {
    /// How many nodes it has, if it is not refused.
    pub fn nodes(self) -> usize {
        match self {
            Self::Point => 1,
            Self::Line => 2,
            Self::Triangle => 3,
            Self::Tetrahedron => 4,
            Self::Passed(nodes) => nodes,
            Self::Refused(_) => 0,
        }
    }

    /// Its dimension, if it is kept.
    pub fn dimension(self) -> Option<usize> {
        match self {
            Self::Point => Some(0),
            Self::Line => Some(1),
            Self::Triangle => Some(2),
            Self::Tetrahedron => Some(3),
            Self::Passed(_) | Self::Refused(_) => None,
        }
    }
}
