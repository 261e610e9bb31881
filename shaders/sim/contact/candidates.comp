// The triangles that each vertex may touch until the next search: the kCandidatesPerPoint nearest
// ones, in proportion to how far the pair can move, ties by their index. So the result does not
// hang on the order in which the grid yields them.
//
// Within a piece a vertex touches the opposite wall of a slit, or what is far away in the rest
// shape, as another arm; never the material around it or behind it.
//
// Reads X, velocities, rest shape, normals, reaches, the grid. Writes candidates, the list of
// points with any and its length. One thread per vertex. A storage and a command barrier follow.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactVelocitiesBinding) readonly buffer Velocities {
    vec4 velocities[];
};
layout(std430, binding = kContactRestBinding) readonly buffer Rest { vec4 restPositions[]; };
layout(std430, binding = kContactLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactNormalsBinding) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = kContactRestNormalsBinding) readonly buffer RestNormals {
    vec4 restNormals[];
};
layout(std430, binding = kContactBoxesBinding) readonly buffer Boxes { ContactBox boxes[]; };
layout(std430, binding = kContactBucketsBinding) readonly buffer Buckets {
    ContactBucket buckets[];
};
layout(std430, binding = kContactReachBinding) readonly buffer Reaches { PieceReach reaches[]; };
layout(std430, binding = kContactEntriesBinding) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kContactCandidatesBinding) writeonly buffer Candidates {
    ContactCandidate candidates[];
};
layout(std430, binding = kContactPointsBinding) writeonly buffer Points { uint points[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "closest_point.glsl"
#include "directions.glsl"
#include "grid.glsl"

// The best so far, best first.
uint bestTriangle[kCandidatesPerPoint];
float bestThickness[kCandidatesPerPoint];
float bestKey[kCandidatesPerPoint];
uint found = 0u;
// Where the normals of triangles that the vertex may touch can point to.
uint opposed = 0u;

bool comesBefore(float key, uint t, uint place) {
    return key < bestKey[place] || (key == bestKey[place] && t < bestTriangle[place]);
}

void keep(uint t, float key, float thickness) {
    for (uint i = 0u; i < found; ++i) {
        if (bestTriangle[i] == t) return;  // two cells of the search share a bucket
    }
    if (found == kCandidatesPerPoint && !comesBefore(key, t, found - 1u)) return;
    uint place = found < kCandidatesPerPoint ? found++ : found - 1u;
    while (place > 0u && comesBefore(key, t, place - 1u)) {
        bestKey[place] = bestKey[place - 1u];
        bestTriangle[place] = bestTriangle[place - 1u];
        bestThickness[place] = bestThickness[place - 1u];
        --place;
    }
    bestKey[place] = key;
    bestTriangle[place] = t;
    bestThickness[place] = thickness;
}

// How a vertex lies to a triangle in the rest shape.
struct RestPlace {
    float separation;  // [m]
    float height;      // above the triangle's plane [m]
    float size;        // longest edge of the triangle [m]
    bool opposed;      // the normals are
};

RestPlace placeInRest(uint v, uvec4 t) {
    vec3 p = restPositions[v].xyz;
    vec3 a = restPositions[t.x].xyz - p;
    vec3 b = restPositions[t.y].xyz - p;
    vec3 c = restPositions[t.z].xyz - p;
    vec3 normal = cross(b - a, c - a);
    normal /= max(length(normal), 1e-30);
    vec3 weights = closestWeights(a, b, c);
    return RestPlace(length(weights.x * a + weights.y * b + weights.z * c), -dot(normal, a),
                     max(length(b - a), max(length(c - b), length(a - c))),
                     dot(restNormals[v].xyz, normal) < kOpposed);
}

// Of a vertex and a triangle of the same piece.
bool mayTouch(uint v, uvec4 t, RestPlace rest) {
    if (rest.separation < kNearInRest * max(uniforms.h, rest.size)) {
        bool walls = (t.w & 1u) != 0u && (floatBitsToUint(normals[v].w) & kTouchesWall) != 0u;
        return walls && rest.opposed && rest.height >= -kSlabDepth * uniforms.h;
    }
    bool throughArm = rest.opposed && rest.height < -0.5 * rest.separation &&
        rest.separation < kArmWidth * uniforms.h;
    return !throughArm;
}

// None across a slit, so that nothing is pushed apart where a cut has just been made.
float thicknessAt(float separation) {
    return uniforms.thickness * clamp(separation / uniforms.h - 0.5, 0.0, 1.0);
}

void consider(uint v, vec3 p, uint index) {
    uvec4 t = triangles[index];
    if (t.x == v || t.y == v || t.z == v) return;
    if (reaches[t.w >> 8].own < 0.0) return;  // a chip
    vec3 a = positions[t.x].xyz - p;
    vec3 b = positions[t.y].xyz - p;
    vec3 c = positions[t.z].xyz - p;
    vec3 normal = cross(b - a, c - a);
    if (!(dot(normals[v].xyz, normal) < kOpposed * length(normal))) return;
    vec3 speed = velocities[v].xyz -
        (velocities[t.x].xyz + velocities[t.y].xyz + velocities[t.z].xyz) / 3.0;
    float range = min(uniforms.margin, uniforms.reach + uniforms.interval * length(speed));
    vec3 weights = closestWeights(a, b, c);
    float away = length(weights.x * a + weights.y * b + weights.z * c);
    if (!(away <= range)) return;
    RestPlace rest = placeInRest(v, t);
    if (t.w >> 8 == links[v].piece && !mayTouch(v, t, rest)) return;
    keep(index, away / range, thicknessAt(rest.separation));
}

// Triangles that pass a first look wait for a second one. Where a branch costs as much as both of
// its sides, a loop that ends early is what saves work: most vertices have none that wait.
const uint kMostPending = 32u;
// Of the margin: what floats may say of a box's distance against the triangle's.
const float kSlack = 0.01;
const int kMostCells = 6;            // along an axis
uint pending[kMostPending];
uint waiting;
float farthest;  // from here no box holds one of the nearest [m]
uint ownPiece;
PieceReach reach;

float limitFor(bool own) {
    return min(farthest, own ? reach.own : reach.others);
}

void look(vec3 p, uint index) {
    vec4 low = boxes[index].low;
    vec4 high = boxes[index].high;
    vec3 outside = max(max(low.xyz - p, p - high.xyz), vec3(0.0));
    bool mayOppose = (opposed >> (floatBitsToUint(low.w) - kFirstBin) & 1u) != 0u;
    float limit = limitFor(floatBitsToUint(high.w) - kFirstBin == ownPiece);
    if (mayOppose && dot(outside, outside) <= limit * limit) {
        pending[waiting] = index;
        ++waiting;
    }
}

// Where the search goes on.
struct Cursor {
    uint levels;  // those still to search, a bit each
    int cell;     // of the first of them
};

// Buckets that are worth a look, as ranges of entries. They are listed first and looked through
// then: neighbours find theirs in different cells, and would wait for one another in each.
const uint kMostListed = 12u;
uint listedFirst[kMostListed];
uint listedEnd[kMostListed];
uint listed;

// Whether the bucket may hold something that the vertex touches.
bool isWorthALook(vec3 p, uint bucket) {
    if ((buckets[bucket].directions & opposed) == 0u) return false;
    ContactBucket all = buckets[bucket];
    bool own = all.first_piece == ownPiece && all.last_piece == ownPiece;
    bool other = all.first_piece > ownPiece || all.last_piece < ownPiece;
    float limit = own ? reach.own : (other ? reach.others : max(reach.own, reach.others));
    vec3 outside = max(max(vec3(all.low_x, all.low_y, all.low_z) - p,
                           p - vec3(all.high_x, all.high_y, all.high_z)), vec3(0.0));
    limit = min(farthest, limit);
    return dot(outside, outside) <= limit * limit;
}

// Lists buckets of a level until there is no room for more. Whether it is through.
bool listLevel(vec3 p, uint level, inout Cursor cursor) {
    float size = cellSize(level);
    float halfBox = 0.5 * min(size, uintBitsToFloat(state.largest[level]));
    float range = halfBox + max(reach.own, reach.others);
    ivec3 low = ivec3(floor((p - range) / size));
    // No reach is three cells wide; a number that is not finite may say anything.
    ivec3 count = clamp(ivec3(floor((p + range) / size)) - low, 0, kMostCells - 1) + 1;
    int cells = count.x * count.y * count.z;
    for (; cursor.cell < cells && listed < kMostListed; ++cursor.cell) {
        int i = cursor.cell;
        ivec3 place = ivec3(i % count.x, (i / count.x) % count.y, i / (count.x * count.y));
        uint bucket = bucketOf(low + place, level);
        if (isWorthALook(p, bucket)) {
            listedFirst[listed] = buckets[bucket].first;
            listedEnd[listed] = buckets[bucket].end;
            ++listed;
        }
    }
    return cursor.cell >= cells;
}

void listBuckets(vec3 p, inout Cursor cursor) {
    listed = 0u;
    while (cursor.levels != 0u && listed < kMostListed) {
        if (listLevel(p, uint(findLSB(cursor.levels)), cursor)) {
            cursor.levels &= cursor.levels - 1u;
            cursor.cell = 0;
        }
    }
}

void lookThroughListed(uint v, vec3 p) {
    uint place = 0u;
    uint k = listedFirst[0];
    while (place < listed) {
        waiting = 0u;
        while (place < listed && waiting < kMostPending) {
            look(p, entries[k]);
            ++k;
            if (k == listedEnd[place]) {
                ++place;
                k = listedFirst[min(place, kMostListed - 1u)];
            }
        }
        for (uint i = 0u; i < waiting; ++i) {
            consider(v, p, pending[i]);
        }
        if (found == kCandidatesPerPoint) {
            farthest = uniforms.margin * min(1.0, bestKey[found - 1u] + kSlack);
        }
    }
}

void search(uint v, vec3 p) {
    Cursor cursor = Cursor(state.levels, 0);
    farthest = uniforms.margin;
    ownPiece = links[v].piece;
    reach = reaches[ownPiece];
    while (cursor.levels != 0u) {
        listBuckets(p, cursor);
        lookThroughListed(v, p);
    }
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uint piece = links[v].piece;
    if (piece != kNoPiece && reaches[piece].own >= 0.0) {
        opposed = opposedBins(normals[v].xyz);
        search(v, positions[v].xyz);
    }
    uint first = kCandidatesPerPoint * v;
    for (uint i = 0u; i < found; ++i) {
        candidates[first + i] = ContactCandidate(bestTriangle[i], bestThickness[i]);
    }
    if (found < kCandidatesPerPoint) {
        candidates[first + found] = ContactCandidate(kNoVertex, 0.0);
    }
    if (found > 0u) {
        uint place = atomicAdd(state.points, 1u);
        points[place] = v;
        atomicMax(state.point_groups, place / kGroupSize + 1u);
        state.vertex_groups = (uniforms.vertex_count + kGroupSize - 1u) / kGroupSize;
    }
}
