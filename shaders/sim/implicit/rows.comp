// Lists the rows of contact of each piece in the order of its vertices on their pages, and the
// pieces that touch: see ImplicitPiece. One group for each piece. A storage barrier follows.
layout(local_size_x = GROUP) in;
#include "sim/implicit/pieces.glsl"
#include "sim/implicit/contact_rows.glsl"
RECORD_WORDS(kRowOrderUnit) rowOrder;
RECORD_PAIRS(kPageTableUnit) pageTable;
layout(std430, binding = kParentsBinding) readonly buffer Parents { uint parents[]; };
layout(std430, binding = kMadePiecesBinding) writeonly buffer Made { uvec4 made[]; };
layout(std430, binding = kMadeListBinding) writeonly buffer List { uint list[]; };

shared uvec2 found[GROUP];  // 1 for an obstacle, 1 for a triangle
shared uint nextOne;
shared uint isHeld;

uvec2 rowsOf(uint v) {
    if (v == kNoVertex) return uvec2(0u);
    return uvec2(fetch(rows, 6u * v + 1u).w > 0.0 ? 1u : 0u,
                 fetch(rows, 6u * v + 4u).w > 0.0 ? 1u : 0u);
}

// Appends the rows of as many vertices as the group has threads; returns how many there are then.
uint appendRows(uint v, uint first, uint count) {
    uvec2 own = rowsOf(v);
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
        list[at] = 2u * v;
        isHeld = 1u;
    }
    if (own.y != 0u) list[at + own.x] = 2u * v + 1u;
    return count + sum;
}

uint rootOf(uint p) {
    while (parents[p] != p) p = parents[p];
    return p;
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
    uint first = 2u * kPageSize * piece.first_page;
    uint count = 0u;
    for (uint page = 0u; page < piece.page_count; ++page) {
        uint places = kPageSize * fetch(pageTable, piece.first_page + page).x;
        for (uint k = gl_LocalInvocationID.x; k < kPageSize; k += GROUP) {
            count = appendRows(fetch(rowOrder, places + k).x, first, count);
        }
    }
    uint root = rootOf(own);
    findNext(own, root);
    barrier();
    if (gl_LocalInvocationID.x == 0u) made[2u * own + 1u] = uvec4(root, nextOne, count, isHeld);
}
