// The scalars of conjugate gradients, piece by piece: what happens in one reaches no other, unless
// they touch. They follow from the sums that the kernels before left, added up in an order that
// does not depend on the number of threads. The includer has groups of GROUP threads, of which each
// group works for one piece.
#include "sim/implicit/pieces.glsl"
STATE_TEXELS(kProductSumsBinding) productSums;  // two texels a page: ProductSums
STATE_TEXELS(kCoursesUnit) courses;

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

// 0 where there is nothing to divide by.
float ratio(float a, float b) {
    return b > 0.0 ? a / b : 0.0;
}

// Whether the iterations of a piece have ended.
bool hasEnded(uint index) { return fetch(courses, kCourseTexels * index + 1u).z != 0.0; }

// By which it is moved as a whole (leave.comp).
vec3 balancingShift(uint index) { return fetch(courses, kCourseTexels * index + 2u).xyz; }
