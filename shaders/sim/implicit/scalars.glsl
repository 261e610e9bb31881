// The scalars of conjugate gradients, piece by piece: what happens in one reaches no other. They
// follow from the sums that the kernels before left, added up in an order that does not depend on
// the number of threads. The includer has groups of GROUP threads, of which each group works for
// one piece.
#include "sim/implicit/uniforms.glsl"
RECORD_QUADS(kPiecesUnit) pieces;
STATE_TEXELS(kProductSumsBinding) productSums;  // two texels a page: ProductSums
STATE_TEXELS(kAnswerSumsBinding) answerSums;    // two texels an aggregate: AnswerSums

// Sums go by rows: what lies a multiple of so many places apart, then the rows. With groups of as
// many threads each has a row for itself.
const uint kRows = 8u;
shared vec4 rowSums[2u * kRows];

struct TwoSums {
    vec4 first;
    vec4 second;
};

ImplicitPiece pieceAt(uint index) {
    uvec4 words = fetch(pieces, index);
    return ImplicitPiece(words.x, words.y, words.z, words.w);
}

void leaveRow(uint row, TwoSums sums) {
    rowSums[2u * row] = sums.first;
    rowSums[2u * row + 1u] = sums.second;
}

// Of the rows, which all threads have left; they may leave others after it.
TwoSums sumOfRows() {
    barrier();
    TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
    for (uint row = 0u; row < kRows; ++row) {
        sums.first += rowSums[2u * row];
        sums.second += rowSums[2u * row + 1u];
    }
    barrier();
    return sums;
}

// Where the sums of a page begin.
uint productsAt(uint slot, uint page) { return 2u * (slot * implicit.page_count + page); }

// What pages know of their whole piece: ProductSums.
vec4 knownOf(ImplicitPiece piece, uint slot) {
    return fetch(productSums, productsAt(slot, piece.first_page) + 1u);
}

TwoSums sumOfProducts(ImplicitPiece piece, uint slot) {
    for (uint row = gl_LocalInvocationID.x; row < kRows; row += GROUP) {
        TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
        for (uint k = row; k < piece.page_count; k += kRows) {
            uint at = productsAt(slot, piece.first_page + k);
            sums.first += fetch(productSums, at);
            sums.second += fetch(productSums, at + 1u);
        }
        leaveRow(row, sums);
    }
    return sumOfRows();
}

TwoSums sumOfAnswers(ImplicitPiece piece, uint slot) {
    for (uint row = gl_LocalInvocationID.x; row < kRows; row += GROUP) {
        TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
        for (uint k = row; k < piece.aggregate_count; k += kRows) {
            uint at = 2u * (slot * implicit.aggregate_count + piece.first_aggregate + k);
            sums.first += fetch(answerSums, at);
            sums.second += fetch(answerSums, at + 1u);
        }
        leaveRow(row, sums);
    }
    return sumOfRows();
}

// 0 where there is nothing to divide by.
float ratio(float a, float b) {
    return b > 0.0 ? a / b : 0.0;
}

// Of an iteration: how much of the last direction stays, and of the pressure goes.
struct Turn {
    float beta;
    float pressure;
    float size;   // r . z
    float gamma;  // dV/dp . pressure
};

Turn turnOf(ImplicitPiece piece, uint slot) {
    vec4 now = sumOfAnswers(piece, slot).first;
    vec4 before = knownOf(piece, slot - 1u);
    float beta = slot > kFirstSlot ? max(ratio(now.x, before.y), 0.0) : 0.0;
    return Turn(beta, ratio(now.y, before.z), now.x, before.z);
}

// How far an iteration goes along its direction, and how much pressure it leaves in the residual.
struct Reach {
    float alpha;
    float pressure;
};

Reach reachOf(ImplicitPiece piece, uint slot) {
    vec4 product = sumOfProducts(piece, slot).first;
    vec4 known = knownOf(piece, slot);
    float alpha = ratio(known.y, product.x);
    return Reach(alpha, -alpha * ratio(product.y, known.z));
}
