// A tree of boxes over the triangles, in an order in which neighbours come together. Node i of the
// lowest level holds the kTreeFan triangles from place kTreeFan * i on, a node above as many nodes
// that follow each other. So the shape of the tree follows from the number of triangles alone, and
// a search only fits the boxes anew. What is left over on a level holds nothing.
//
// A node is four texels: low corner [m] and the bins of normals; high corner and the first child;
// lowest velocity [m/s] and first piece; highest velocity and last piece. A triangle is two: low
// corner and bin; high corner and number.
#include "sim/base/ordered_floats.glsl"

const float kNothing = 1e30;  // low corner of a box that holds nothing
const float kAnySpeed = 1e18;  // more than any that is finite and makes sense [m/s]

struct TreeNode {
    vec3 low;
    vec3 high;
    vec3 slowest;
    vec3 fastest;
    uint directions;
    uint firstChild;
    uint firstPiece;
    uint lastPiece;
};

// Of the level above one of so many: whole runs of children.
uint nodesAbove(uint count) {
    uint nodes = (count + kTreeFan - 1u) / kTreeFan;
    return (nodes + kTreeFan - 1u) / kTreeFan * kTreeFan;
}

TreeNode emptyNode() {
    return TreeNode(vec3(kNothing), vec3(-kNothing), vec3(kAnySpeed), vec3(-kAnySpeed), 0u, 0u,
                    0xffffffffu, 0u);
}
