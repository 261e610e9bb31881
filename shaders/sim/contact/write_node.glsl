void writeNode(uint i, TreeNode node) {
    nodes[4u * i] = uvec4(floatBitsToUint(node.low), node.directions);
    nodes[4u * i + 1u] = uvec4(floatBitsToUint(node.high), node.firstChild);
    nodes[4u * i + 2u] = uvec4(floatBitsToUint(node.slowest), node.firstPiece);
    nodes[4u * i + 3u] = uvec4(floatBitsToUint(node.fastest), node.lastPiece);
}
