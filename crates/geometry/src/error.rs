/// Why a description of a view, a tree or a world cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A size, angle or distance of a view is not finite or out of its range.
    #[error("view: {what} is out of range")]
    View {
        /// The value that cannot be used.
        what: &'static str,
    },
    /// A scale and offset for depths that move the yon plane out of 0 to 1.
    #[error("depth scale and offset move the yon plane out of 0 to 1")]
    DepthScale,
    /// More of something than a list may hold.
    #[error("too many {what}")]
    Limit {
        /// What there is too much of.
        what: &'static str,
    },
    /// A portal of a room that does not exist, or that is no polygon.
    #[error("portal {portal}: no polygon, or a room that does not exist")]
    Portal {
        /// Its place in the list.
        portal: usize,
    },
    /// A node with no plane, or with children that make no tree.
    #[error("node {node}: no plane, or children that make no tree")]
    Node {
        /// Its place in the list.
        node: usize,
    },
}
