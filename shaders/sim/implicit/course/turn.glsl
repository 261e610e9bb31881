// How the iterations of pieces that touch go on: see Course.
#include "sim/implicit/course/last_group.glsl"

const float kRounding = 1e-8;  // of the scale

// Of all that touch.
struct Answered {
    float left;    // left . z
    float size;    // without a change of volume
    float turned;  // the same of what was left before
    float moved;   // the energy of the motion
};

float swellingOf(ImplicitPiece piece, TwoSums now, uint slot) {
    return ratio(now.first.y, knownOf(piece, slot - 1u).z);
}

Answered answered(uint root, uint slot) {
    Answered all = Answered(0.0, 0.0, 0.0, 0.0);
    for (uint p = root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        TwoSums now = sumOfAnswers(piece, slot);
        float swelling = swellingOf(piece, now, slot);
        all.left += now.first.x;
        all.size += now.first.x - swelling * now.first.w;
        all.turned += now.first.z - swelling * now.second.x;
        if (slot == kFirstSlot) all.moved += sumOfProducts(piece, kStartSlot).first.w;
        if (gl_LocalInvocationID.x == 0u) newCourses[p].pressure = swelling;
        p = piece.next;
    }
    return all;
}

// Polak and Ribiere's beta, since contact bends the way.
void leaveCourses(uint root, uint slot) {
    Answered all = answered(root, slot);
    if (gl_LocalInvocationID.x != 0u) return;
    bool begins = slot == kFirstSlot;
    for (uint p = root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        vec4 before = knownOf(piece, slot - 1u);
        float scale = begins ? max(all.left, all.moved) : before.w;
        newCourses[p].beta = begins ? 0.0 : max(ratio(all.size - all.turned, before.y), 0.0);
        newCourses[p].size = all.size;
        newCourses[p].gamma = before.z;
        newCourses[p].scale = scale;
        bool done = !(all.size > kRounding * scale);
        bool close = done || all.size < implicit.bounds.close * scale;
        newCourses[p].done = done ? 1.0 : 0.0;
        newCourses[p].ended = close && slot >= numbers.y ? 1.0 : 0.0;
        p = piece.next;
    }
}
