// Where corners and edges of boxes meet triangles: a box may be smaller than a triangle, so that no
// vertex gets near it. Of a box and a triangle the most urgent touch counts, where the gap ends up
// smallest. Normals and gaps are those at X, so that what crosses within a substep is met:
//
//   corner  against the triangle, along the triangle's normal
//   edge    against an edge of the triangle (which each edge is for one of its two triangles),
//           along the line across both, where that lies between the two faces of the box
//   box     against a triangle that it passes through deeper than corners and edges are looked
//           for, with its middle in front and all corners of the triangle beside the box: along
//           the triangle's normal, until all of the box is in front. So a box that stands or is
//           put deep in a body pushes it out. Where corners lie in it, they lead (keep_out.glsl).
//
// With BLADE it is the body of the blade, whose own way in the substep counts, and which leaves the
// walls along its flat sides to blade.comp: they end where the edge cuts, and give no way there.
//
// The includer declares `obstacle` (BoxUniforms), positionOf(v), displacementOf(v), boxAt(b), with
// BLADE bladeNow().
#include "boxes.glsl"
#include "separation.glsl"
#include "sim/base/lines.glsl"
#include "sim/base/plane_weights.glsl"

#ifdef BLADE
#include "blade.glsl"

BoxRecord boxAt(uint b) { return bladeNow().box; }

vec3 wayOf(uint v) {
    return displacementOf(v).xyz - wayOfBlade(bladeNow(), positionOf(v).xyz);
}

// Across the flat sides by more than 45 degrees.
bool isLeftOut(uvec4 t, vec3 normal) { return (t.w & 1u) != 0u && abs(normal.z) > 0.7; }
#else
vec3 wayOf(uint v) { return displacementOf(v).xyz; }

bool isLeftOut(uvec4 t, vec3 normal) { return false; }
#endif

// Positions and displacements of the corners of a triangle, in the coordinates of a box.
struct Corners {
    vec3 at[3];
    vec3 way[3];
};

struct Touch {
    vec3 normal;
    float before;  // gap at X [m]
    vec3 slip;     // of the touched point [m]
    float gap;     // at X + d [m]
    vec3 weights;
};

Corners cornersIn(BoxRecord box, uvec3 t) {
    Corners c;
    for (int k = 0; k < 3; ++k) {
        c.at[k] = toBox(box, positionOf(t[k]).xyz - box.center.xyz);
        c.way[k] = toBox(box, wayOf(t[k]));
    }
    return c;
}

bool nearBox(Corners c, vec3 reach) {
    vec3 low = vec3(1e30);
    vec3 high = vec3(-1e30);
    for (int k = 0; k < 3; ++k) {
        vec3 end = c.at[k] + c.way[k];
        low = min(low, min(c.at[k], end));
        high = max(high, max(c.at[k], end));
    }
    return all(lessThan(low, reach)) && all(greaterThan(high, -reach));
}

Touch touchAt(Corners c, vec3 normal, float before, vec3 weights) {
    vec3 slip = weights.x * c.way[0] + weights.y * c.way[1] + weights.z * c.way[2];
    return Touch(normal, before, slip, before + dot(normal, slip), weights);
}

Touch moreUrgent(Touch a, Touch b) {
    if (b.gap < a.gap) return b;
    return a;
}

// Only a box in front of the triangle touches it: its middle lies there, as seen from the corner.
Touch cornerTouch(Touch best, Corners c, vec3 normal, vec3 corner) {
    float before = dot(normal, c.at[0] - corner);  // normal: into the body, away from the box
    if (dot(normal, corner) <= 0.0 || before < -obstacle.depth) return best;
    vec3 weights = planeWeights(c.at[0] + c.way[0], c.at[1] + c.way[1], c.at[2] + c.way[2], corner);
    if (min(weights.x, min(weights.y, weights.z)) < 0.0) return best;
    return moreUrgent(best, touchAt(c, normal, before, weights));
}

// Between corner i of the triangle and the next, and the edge of the box along `axis` that starts
// at the corner `start`, which has this axis negative.
Touch edgeTouch(Touch best, Corners c, vec3 normal, int i, int axis, vec3 start) {
    int j = (i + 1) % 3;
    vec3 along = vec3(0.0);
    along[axis] = -2.0 * start[axis];
    vec3 edge = c.at[j] - c.at[i];
    vec3 across = cross(edge, along);
    float size = length(across);
    if (size < 1e-3 * length(edge) * along[axis]) return best;
    vec3 outward = start;
    outward[axis] = 0.0;
    across *= (dot(across, outward) < 0.0 ? -1.0 : 1.0) / size;
    bool betweenFaces = all(greaterThanEqual(across * outward, vec3(0.0)));
    if (!betweenFaces || dot(across, normal) <= 0.0) return best;
    float before = dot(across, c.at[i] - start);
    if (before < -obstacle.depth) return best;
    vec3 from = c.at[i] + c.way[i];
    vec2 where = nearestOnLines(from, c.at[j] + c.way[j] - from, start, along);
    if (any(lessThan(where, vec2(0.0))) || any(greaterThan(where, vec2(1.0)))) return best;
    vec3 weights = vec3(0.0);
    weights[i] = 1.0 - where.x;
    weights[j] = where.x;
    return moreUrgent(best, touchAt(c, across, before, weights));
}

#ifdef BLADE
Touch pierced(Touch best, Corners c, vec3 normal, vec3 reach) { return best; }
#else
bool isBeside(vec3 p, vec3 reach) {
    return any(greaterThan(abs(p), reach - kSkinDeep * obstacle.depth));
}

Touch pierced(Touch best, Corners c, vec3 normal, vec3 reach) {
    float middle = dot(normal, c.at[0]);
    float before = middle - dot(abs(normal), reach);
    bool passes = middle > 0.0 && before < -obstacle.depth && isBeside(c.at[0], reach) &&
                  isBeside(c.at[1], reach) && isBeside(c.at[2], reach);
    // A loop, since llvmpipe runs both sides of a branch.
    for (int i = passes ? 0 : 1; i < 1; ++i) {
        Plane plane = widestPlane(facePlane(c.at, reach), c.at, reach);
        passes = plane.gap < -kSkinDeep * obstacle.depth;
    }
    if (!passes) return best;
    return moreUrgent(best, touchAt(c, normal, before, vec3(1.0 / 3.0)));
}
#endif

// With a gap below `least`; else its gap is that.
Touch touchOf(BoxRecord box, Corners c, uvec4 t, float least) {
    Touch best = Touch(vec3(0.0), 0.0, vec3(0.0), least, vec3(0.0));
    vec3 reach = halfOf(box);
    if (!nearBox(c, reach + max(least, obstacle.thickness))) return best;
    vec3 normal = -cross(c.at[1] - c.at[0], c.at[2] - c.at[0]);
    normal /= max(length(normal), 1e-30);
    if (isLeftOut(t, normal)) return best;
    for (int corner = 0; corner < 8; ++corner) {
        vec3 p = reach * (2.0 * vec3(corner & 1, (corner >> 1) & 1, corner >> 2) - 1.0);
        best = cornerTouch(best, c, normal, p);
        for (int i = 0; i < 3; ++i) {
            if (t[i] > t[(i + 1) % 3]) continue;
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < 0.0) best = edgeTouch(best, c, normal, i, axis, p);
            }
        }
    }
    return pierced(best, c, normal, reach);
}
