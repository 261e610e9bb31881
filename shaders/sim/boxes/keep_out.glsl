// Keeps vertices out of boxes: d ends at the face that the way from X to X + d enters through, a
// thickness away from it. What starts inside comes out, slowly: a piece that the box could hold as
// a whole through the one face where it has the least way, vertices of others through the nearest.
// Coulomb friction shortens the tangential way; a piece that leaves as a whole goes straight.
// The includer declares `obstacle` (BoxUniforms), positionOf(v), displacementOf(v), pieceOf(v),
// boxAt(b), pieceBounds(p).
#include "boxes.glsl"
#include "sim/base/ordered_floats.glsl"

// A face that stops a vertex; axis 3 for none.
struct Face {
    int axis;
    float side;  // 1 or -1
    float gap;   // to it at X [m]
    bool whole;  // a piece leaves through it
};

// About how far a piece reaches, in the coordinates of a box: as an ellipsoid that fills the box
// around it in the world.
struct PieceBox {
    vec3 middle;
    vec3 reach;
    float low;  // in the world [m]
};

int largest(vec3 v) {
    return v.x >= v.y && v.x >= v.z ? 0 : (v.y >= v.z ? 1 : 2);
}

float sideOf(float at) { return at < 0.0 ? -1.0 : 1.0; }

// The last of the three slabs that the way enters is where it meets the box.
Face entered(vec3 at, vec3 way, vec3 reach) {
    vec3 outside = abs(at) - reach;
    vec3 inward = -sign(at) * way;
    vec3 when = vec3(-1.0);
    for (int k = 0; k < 3; ++k) {
        if (outside[k] > 0.0) {
            if (!(inward[k] > outside[k])) return Face(3, 0.0, 0.0, false);
            when[k] = outside[k] / inward[k];
        }
    }
    int axis = largest(when);
    vec3 beside = abs(at + when[axis] * way) - reach;
    beside[axis] = 0.0;
    bool meets = all(lessThanEqual(beside, vec3(0.0)));
    return Face(meets ? axis : 3, sideOf(at[axis]), outside[axis], false);
}

PieceBox pieceBoxIn(BoxRecord box, uint p) {
    PieceBounds bounds = pieceBounds(p);
    vec3 low = vec3(orderedFloat(bounds.low_x), orderedFloat(bounds.low_y),
                    orderedFloat(bounds.low_z));
    vec3 high = vec3(orderedFloat(bounds.high_x), orderedFloat(bounds.high_y),
                     orderedFloat(bounds.high_z));
    vec3 reach = 0.5 * (high - low);
    return PieceBox(toBox(box, 0.5 * (low + high) - box.center.xyz),
                    vec3(length(box.x.xyz * reach), length(box.y.xyz * reach),
                         length(box.z.xyz * reach)),
                    low.y);
}

// Whether a piece that leaves so far along an axis, up or down, comes to lie in the floor.
bool endsInFloor(PieceBox piece, float up, float way) {
    return piece.low + up * way < obstacle.floor_height - 0.01 * way;
}

// The face through which a piece has the least way out, the floor permitting.
Face wayOutOf(BoxRecord box, PieceBox piece) {
    Face best = Face(3, 0.0, 0.0, true);
    float least = 1e30;
    vec3 up = vec3(box.x.y, box.y.y, box.z.y);
    vec3 far = halfOf(box) + piece.reach;
    for (int k = 0; k < 6; ++k) {
        int axis = k % 3;
        float side = k < 3 ? 1.0 : -1.0;
        float way = far[axis] - side * piece.middle[axis];
        if (way < least && !endsInFloor(piece, side * up[axis], way)) {
            least = way;
            best = Face(axis, side, 0.0, true);
        }
    }
    return best;
}

// Whether beside the way out through this face the box is as wide as the piece and around its
// middle.
bool holds(BoxRecord box, PieceBox piece, Face face) {
    vec3 room = halfOf(box) - max(piece.reach, abs(piece.middle));
    if (face.axis < 3) room[face.axis] = 0.0;
    return face.axis < 3 && all(greaterThanEqual(room, vec3(0.0)));
}

Face faceFor(BoxRecord box, uint v, vec3 at, vec3 way) {
    vec3 reach = halfOf(box) + obstacle.thickness;
    vec3 outside = abs(at) - reach;
    int axis = largest(outside);
    if (outside[axis] > 0.0) return entered(at, way, reach);
    Face nearest = Face(axis, sideOf(at[axis]), outside[axis], false);
    bool touches = outside[axis] > -obstacle.thickness - kSkinDeep * obstacle.depth;
    if (touches || pieceOf(v) == kNoPiece) return nearest;
    PieceBox piece = pieceBoxIn(box, pieceOf(v));
    Face leaving = wayOutOf(box, piece);
    if (!holds(box, piece, leaving)) return nearest;
    leaving.gap = leaving.side * at[leaving.axis] - reach[leaving.axis];
    return leaving;
}

vec3 keptOut(BoxRecord box, uint v, vec3 x, vec3 d) {
    vec3 way = toBox(box, d);
    Face face = faceFor(box, v, toBox(box, x - box.center.xyz), way);
    if (face.axis == 3) return d;
    float least = min(-face.gap, obstacle.lift);
    float lift = least - face.side * way[face.axis];
    if (!(lift > 0.0)) return d;
    float across = way[face.axis];
    way[face.axis] = 0.0;
    way *= face.whole ? 0.0 : slipLeft(length(way), lift, obstacle.friction);
    way[face.axis] = across + face.side * lift;
    return fromBox(box, way);
}

// Its d, kept out of all boxes in their order.
vec3 outOfBoxes(uint v) {
    vec3 x = positionOf(v).xyz;
    vec3 d = displacementOf(v).xyz;
    for (uint b = 0u; b < obstacle.box_count; ++b) {
        d = keptOut(boxAt(b), v, x, d);
    }
    return d;
}
