// Boxes and the bounds of pieces where a kernel fetches them. The includer declares `boxes` and
// `boundsOfPieces`.
BoxRecord boxAt(uint b) {
    return BoxRecord(fetch(boxes, 4u * b), fetch(boxes, 4u * b + 1u), fetch(boxes, 4u * b + 2u),
                     fetch(boxes, 4u * b + 3u));
}
uint boundAt(uint p, uint k) { return fetch(boundsOfPieces, 6u * p + k).x; }
PieceBounds pieceBounds(uint p) {
    return PieceBounds(boundAt(p, 0u), boundAt(p, 1u), boundAt(p, 2u), boundAt(p, 3u),
                       boundAt(p, 4u), boundAt(p, 5u));
}
