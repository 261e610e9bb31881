// Lists the rows of contact of each piece in the order of its vertices on their pages, then those
// of pulls, and the pieces that touch: see ImplicitPiece.
// Numbers: the first row of pulls, how many. One group for each piece. A storage barrier follows.
#include "sim/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/pieces.glsl"
#include "sim/implicit/contact_rows.glsl"
RECORD_WORDS(kRowOrderUnit) rowOrder;
RECORD_PAIRS(kPageTableUnit) pageTable;
layout(std430, binding = kParentsBinding) coherent buffer Parents { uint parents[]; };
layout(std430, binding = kMadePiecesBinding) writeonly buffer Made { uvec4 made[]; };
layout(std430, binding = kMadeListBinding) writeonly buffer List { uint list[]; };
#include "sim/implicit/join.glsl"

shared uvec2 found[GROUP];  // 1 for an obstacle, 1 for a triangle
shared uint nextOne;
shared uint isHeld;
uint firstPull = numbers.x;
uint pullCount = numbers.y;

bool isRow(uint row) { return fetch(rows, 3u * row + 1u).w > 0.0; }

// Two rows, of which there may be the first and the second.
struct Pair {
    uvec2 rows;
    uvec2 there;
};

Pair pairOf(uint v) {
    if (v == kNoVertex) return Pair(uvec2(0u), uvec2(0u));
    return Pair(uvec2(2u * v, 2u * v + 1u), uvec2(isRow(2u * v), isRow(2u * v + 1u)));
}

// Of a hand or a bond.
Pair pullOf(uint row, uint piece) {
    bool there = row < firstPull + pullCount && isRow(row) &&
        uint(fetch(rows, 3u * row + 2u).x) == piece;
    bool isBond = there && fetch(rows, 3u * row + 2u).y != 0.0;
    return Pair(uvec2(row), uvec2(there && !isBond, isBond));
}

// Appends the rows of as many vertices as the group has threads; returns how many there are then.
uint append(Pair pair, uint first, uint count) {
    uvec2 own = pair.there;
    found[gl_LocalInvocationID.x] = own;
    barrier();
    uint place = 0u;
    uint sum = 0u;
    for (uint k = 0u; k < GROUP; ++k) {
        if (k == gl_LocalInvocationID.x) place = sum;
        sum += found[k].x + found[k].y;
    }
    barrier();
    uint at = first + count + place;
    if (own.x != 0u) {
        list[at] = pair.rows.x;
        isHeld = 1u;
    }
    if (own.y != 0u) list[at + own.x] = pair.rows.y;
    return count + sum;
}

// Leaves the first piece behind this one that touches it, be it by others.
void findNext(uint own, uint root) {
    for (uint p = own + 1u + gl_LocalInvocationID.x; p < implicit.piece_count; p += GROUP) {
        if (rootOf(p) == root) {
            atomicMin(nextOne, p);
            break;
        }
    }
}

void main() {
    uint own = gl_WorkGroupID.x;
    ImplicitPiece piece = pieceAt(own);
    if (gl_LocalInvocationID.x == 0u) {
        nextOne = kNoPiece;
        isHeld = 0u;
    }
    barrier();
    uint first = kRowsOfPage * piece.first_page;
    uint count = 0u;
    for (uint page = 0u; page < piece.page_count; ++page) {
        uint places = kPageSize * fetch(pageTable, piece.first_page + page).x;
        for (uint k = gl_LocalInvocationID.x; k < kPageSize; k += GROUP) {
            count = append(pairOf(fetch(rowOrder, places + k).x), first, count);
        }
    }
    for (uint k = 0u; k < pullCount; k += GROUP) {
        count = append(pullOf(firstPull + k + gl_LocalInvocationID.x, own), first, count);
    }
    uint root = rootOf(own);
    findNext(own, root);
    barrier();
    if (gl_LocalInvocationID.x == 0u) made[2u * own + 1u] = uvec4(root, nextOne, count, isHeld);
}
