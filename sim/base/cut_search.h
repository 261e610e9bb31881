#pragma once

namespace kerf {

/// How the triangles near the blade's strip are found. All find the same.
enum class CutSearch {
    tree,       ///< by position, in a tree of boxes or as listed by the GPU
    adjacency,  ///< as in the paper: a seed, then from neighbour to neighbour
    all,        ///< each triangle of the body is tested, as before the paper
};

}  // namespace kerf
