// Joins pieces that touch. The includer declares `parents`, coherent.
uint rootOf(uint p) {
    while (parents[p] != p) p = parents[p];
    return p;
}

// The root of pieces that touch is the first of them, whoever comes first.
void join(uint a, uint b) {
    a = rootOf(a);
    b = rootOf(b);
    while (a != b) {
        uint high = max(a, b);
        if (atomicCompSwap(parents[high], high, min(a, b)) == high) break;
        a = rootOf(a);
        b = rootOf(b);
    }
}
