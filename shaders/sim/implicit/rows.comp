// Lists the rows of contact of each piece in the order of its vertices on their pages, then those
// of pulls, and the pieces that touch: see ImplicitPiece.
// Numbers: the first row of pulls, how many, 1 where an edge presses. One group for each piece. A
// storage barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/pieces.glsl"
#include "sim/implicit/contact_rows.glsl"
RECORD_WORDS(kRowOrderUnit) rowOrder;
RECORD_PAIRS(kPageTableUnit) pageTable;
layout(std430, binding = kParentsBinding) coherent buffer Parents { uint parents[]; };
layout(std430, binding = kMadePiecesBinding) writeonly buffer Made { uvec4 made[]; };
layout(std430, binding = kMadeListBinding) writeonly buffer List { uint list[]; };
#include "sim/implicit/join.glsl"

shared uint found[GROUP];
shared uint nextOne;
shared uint isHeld;
uint firstPull = numbers.x;
uint pullCount = numbers.y;
bool edgePresses = numbers.z != 0u;

// Rows that follow each other, of which there are those with a bit.
struct Rows {
    uint first;
    uint there;
    bool hold;  // the first and the last: see ImplicitPiece
};

uint bitOf(uint row) { return stiffnessOf(row) > 0.0 ? 1u : 0u; }

Rows rowsOf(uint v) {
    Rows own = Rows(kRowsOfVertex * v, 0u, true);
    for (uint k = 0u; v != kNoVertex && k < kRowsOfVertex; ++k) {
        own.there |= bitOf(own.first + k) << k;
    }
    return own;
}

// Of an edge that presses.
Rows pressedRowOf(uint v) {
    uint row = firstPull + pullCount + v;
    return Rows(row, v == kNoVertex ? 0u : bitOf(row), true);
}

// Of a hand or a bond.
Rows pullOf(uint row, uint piece) {
    bool there = row < firstPull + pullCount && stiffnessOf(row) > 0.0 &&
        uint(fetch(rows, kRowTexels * row).w) == piece;
    bool isHand = there && fetch(rows, kRowTexels * row + 2u).x == kOfObstacle;
    return Rows(row, there ? 1u : 0u, isHand);
}

// Appends rows of as many vertices as the group has threads; returns how many there are then.
uint append(Rows own, uint first, uint count) {
    found[gl_LocalInvocationID.x] = uint(bitCount(own.there));
    barrier();
    uint place = 0u;
    uint sum = 0u;
    for (uint k = 0u; k < GROUP; ++k) {
        if (k == gl_LocalInvocationID.x) place = sum;
        sum += found[k];
    }
    barrier();
    uint at = first + count + place;
    for (uint there = own.there; there != 0u; there &= there - 1u) {
        list[at] = own.first + uint(findLSB(there));
        ++at;
    }
    bool holds = (own.there & (1u << kMeetsObstacle | 1u << kMeetsCorner)) != 0u;
    if (own.hold && holds) atomicOr(isHeld, 1u);
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
            uint v = fetch(rowOrder, places + k).x;
            count = append(rowsOf(v), first, count);
            if (edgePresses) count = append(pressedRowOf(v), first, count);
        }
    }
    for (uint k = 0u; k < pullCount; k += GROUP) {
        count = append(pullOf(firstPull + k + gl_LocalInvocationID.x, own), first, count);
    }
    uint root = rootOf(own);
    findNext(own, root);
    barrier();
    if (gl_LocalInvocationID.x == 0u) {
        float unit = isHeld != 0u ? -forceUnitOf(own) : forceUnitOf(own);
        made[2u * own + 1u] = uvec4(root, nextOne, count, floatBitsToUint(unit));
    }
}
