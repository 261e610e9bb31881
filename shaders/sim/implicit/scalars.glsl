// The scalars of conjugate gradients, piece by piece: what happens in one reaches no other, unless
// they touch. They follow from the sums that the kernels before left, added up in an order that
// does not depend on the number of threads. The includer has groups of GROUP threads, of which each
// group works for one piece.
#include "sim/implicit/pieces.glsl"
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
    float size;   // left . z without a change of volume, of all that touch
    float gamma;  // dV/dp . pressure
    float scale;  // of left . z: what it was at first, or the energy of the motion
    bool done;    // what is left is rounding, along which directions would grow
};

const float kRounding = 1e-12;  // of the scale

// Polak and Ribiere's, since contact bends the way.
Turn turnOf(uint index, uint slot) {
    ImplicitPiece piece = pieceAt(index);
    vec4 before = knownOf(piece, slot - 1u);
    bool begins = slot == kFirstSlot;
    float size = 0.0;
    float left = 0.0;
    float turned = 0.0;
    float pressure = 0.0;
    float moved = 0.0;
    for (uint p = piece.root; p != kNoPiece;) {
        ImplicitPiece other = pieceAt(p);
        TwoSums now = sumOfAnswers(other, slot);
        float swelling = ratio(now.first.y, knownOf(other, slot - 1u).z);
        left += now.first.x;
        size += now.first.x - swelling * now.first.w;
        turned += now.first.z - swelling * now.second.x;
        if (p == index) pressure = swelling;
        if (begins) moved += sumOfProducts(other, kStartSlot).first.w;
        p = other.next;
    }
    float beta = begins ? 0.0 : max(ratio(size - turned, before.y), 0.0);
    float scale = begins ? max(left, moved) : before.w;
    return Turn(beta, pressure, size, before.z, scale, !(left > kRounding * scale));
}
