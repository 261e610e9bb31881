// A block of the matrix is a sum of products of factors (factors.comp).
STATE_TEXELS(kFactorsUnit) factors;
RECORD_WORDS(kBlockSharesUnit) blockShares;

struct BlockSum {
    vec3 x, y, z;  // rows
};

// Where the factors of a share of a block begin; its slots follow (kSlotBits).
uint factorsOf(uint share) { return share >> kSlotBits << 1; }

void addTo(inout BlockSum sum, vec4 a, vec4 b) {
    sum.x += a.x * b.xyz;
    sum.y += a.y * b.xyz;
    sum.z += a.z * b.xyz;
    float across = a.w * b.w;
    sum.x.x += across;
    sum.y.y += across;
    sum.z.z += across;
}
