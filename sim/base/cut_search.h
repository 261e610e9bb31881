#pragma once

namespace kerf {

/// How the triangles near the blade's strip are found. All ways find the same.
enum class CutSearch {
    tree,       ///< by where they lie, in a tree of boxes or as the GPU lists them
    adjacency,  ///< as in the paper: a seed, then from neighbour to neighbour
    all,        ///< each triangle of the body is tested, as before the paper
};

}  // namespace kerf
