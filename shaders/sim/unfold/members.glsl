#pragma once
// The members of the goal of v, whose neighbours lie at `range`: itself, then them. The includer
// declares `neighbours`, which is read by pairs.
uint memberOf(uint v, uvec2 range, uint i) {
    uint place = range.x + max(i, 1u) - 1u;
    uvec2 pair = fetch(neighbours, place / 2u).xy;
    return i == 0u ? v : ((place & 1u) == 0u ? pair.x : pair.y) & ~kAfterGap;
}

uint memberCount(uvec2 range) {
    return range.y - range.x + 1u;
}
