// A level of the tree from the one below. Reads and writes nodes. One thread per node. A storage
// barrier follows.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactNodesBinding) buffer Nodes { uvec4 nodes[]; };

#include "sim/numbers.glsl"
#include "tree.glsl"
#include "write_node.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= numbers.y) return;
    TreeNode node = emptyNode();
    node.firstChild = numbers.z + kTreeFan * i;
    uint end = min(node.firstChild + kTreeFan, numbers.x);
    for (uint child = node.firstChild; child < end; ++child) {
        uvec4 low = nodes[4u * child];
        uvec4 high = nodes[4u * child + 1u];
        uvec4 slowest = nodes[4u * child + 2u];
        uvec4 fastest = nodes[4u * child + 3u];
        node.low = min(node.low, uintBitsToFloat(low.xyz));
        node.high = max(node.high, uintBitsToFloat(high.xyz));
        node.slowest = min(node.slowest, uintBitsToFloat(slowest.xyz));
        node.fastest = max(node.fastest, uintBitsToFloat(fastest.xyz));
        node.directions |= low.w;
        node.firstPiece = min(node.firstPiece, slowest.w);
        node.lastPiece = max(node.lastPiece, fastest.w);
    }
    writeNode(numbers.x + i, node);
}
