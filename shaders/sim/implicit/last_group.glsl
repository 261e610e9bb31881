// What the group finds that is done last of all that work for pieces that touch. The includer has
// groups of GROUP threads, of which each works for an aggregate and adds to `newSums`.
#include "sim/implicit/scalars.glsl"
layout(std430, binding = kAnswerSumsBinding) coherent buffer Sums { vec4 newSums[]; };
layout(std430, binding = kMadeCoursesBinding) coherent buffer Courses { Course newCourses[]; };

// Of the sums that the groups of this dispatch leave.
TwoSums sumOfAnswers(ImplicitPiece piece, uint slot) {
    for (uint row = gl_LocalInvocationID.x; row < kRows; row += GROUP) {
        TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
        for (uint k = row; k < piece.aggregate_count; k += kRows) {
            uint at = 2u * (slot * implicit.aggregate_count + piece.first_aggregate + k);
            sums.first += newSums[at];
            sums.second += newSums[at + 1u];
        }
        leaveRow(row, sums);
    }
    return sumOfRows();
}

shared bool isLast;

// Of all that work for pieces that touch this one.
bool isLastGroup(ImplicitPiece own) {
    memoryBarrierBuffer();
    if (gl_LocalInvocationID.x == 0u) {
        uint groups = 0u;
        for (uint p = own.root; p != kNoPiece;) {
            ImplicitPiece piece = pieceAt(p);
            groups += piece.aggregate_count;
            p = piece.next;
        }
        isLast = atomicAdd(newCourses[own.root].groups, 1u) == groups - 1u;
        if (isLast) newCourses[own.root].groups = 0u;
    }
    memoryBarrierBuffer();
    barrier();
    return isLast;
}
