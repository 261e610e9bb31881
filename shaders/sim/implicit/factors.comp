// What constraints of one type resist motion by at X: of each slot, that is of each vertex, a
// texel of which the blocks of the matrix are sums of products,
//   xyz  gradient * sqrt(stiffness along it)    w  weight * sqrt(stiffness across it)
// and of each constraint its force over that root. Of an edge both its spokes have their own.
// Numbers: how many there are, the first texel, and of those that are bound the first and how many.
// One thread per constraint, or place of a spoke. A storage barrier follows, then blocks.
#include "constraints.h"
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
RECORD_QUADS(kConstraintsBinding) records;
layout(std430, binding = kMadeFactorsBinding) writeonly buffer Factors { vec4 factors[]; };
layout(std430, binding = kMadePullsBinding) writeonly buffer Pulls { float pulls[]; };

void storeFactor(uint at, vec4 factor) {
    if (at - numbers.z < numbers.w) factors[at - numbers.z] = factor;
}

// Of a constraint whose texels begin at `at`.
void setPull(uint at, float pull) { pulls[at / 2u] = pull; }

// A spring at X: an edge or an ISPC.
struct Spring {
    vec3 root;     // direction * sqrt(stiffness along it less that across)
    float across;  // root of the stiffness across it, where it is stretched or crushed
    float pull;    // force over the first root
};

Spring springOf(vec3 span, float restLength, float stiffness) {
    float reach = length(span);
    float error = reach - restLength;
    float turns = max(error, -error - kMostBuckling * restLength) / max(reach, 1e-12);
    float across = stiffness * clamp(turns, 0.0, kMostAcross);
    float root = sqrt(stiffness * (1.0 + implicit.damping) - across);
    bool acts = reach > 1e-12 && stiffness > 0.0;
    return Spring(acts ? span * (root / reach) : vec3(0.0), acts ? sqrt(across) : 0.0,
                  acts ? stiffness * error / root : 0.0);
}

void setFactor(uint at, Spring spring, float weight) {
    storeFactor(at, weight * vec4(spring.root, spring.across));
}

#ifdef OF_EDGES
// A spoke: the texel of its own vertex, then that of the other.
RECORD_WORDS(kSpokeOwnersUnit) owners;

void setFactors(uint place, uint first) {
    Spoke spoke = fetchSpoke(records, place);
    uint own = fetch(owners, place).x;
    bool used = own != kNoVertex;
    vec4 from = fetch(positions, used ? own : 0u);
    vec4 to = fetch(positions, used ? spoke.other : 0u);
    vec3 span = from.xyz - to.xyz;
    float stiffness =
        used ? boundedFirmness(implicit.modulus[kStretch] / spoke.geometry, from.w + to.w) : 0.0;
    Spring spring = springOf(span, spoke.rest_length, stiffness);
    uint at = first + 2u * place;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -1.0);
    setPull(at, spring.pull);
}
#elif defined(OF_BENDS)
// A bend: see constraints/bend.glsl and ConstraintPull.
#include "sim/base/bend_angle.glsl"

void setFactors(uint index, uint first) {
    BendRecord bend = fetchBend(records, index);
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    Wings wings = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    bool slivers = degenerate(wings);
    float e2 = slivers ? 1.0 : dot(wings.edge, wings.edge);
    float reach = sqrt(e2);
    vec3 a = wings.nA * (reach / (slivers ? 1.0 : dot(wings.nA, wings.nA)));
    vec3 b = wings.nB * (reach / (slivers ? 1.0 : dot(wings.nB, wings.nB)));
    float sA = dot(wings.left, wings.edge) / e2;
    float sB = dot(wings.right, wings.edge) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;
    vec4 squares = vec4(dot(g0, g0), dot(g1, g1), dot(a, a), dot(b, b));
    float steepest = max(max(squares.x, squares.y), max(squares.z, squares.w));

    vec2 turn = errorVector(wings, bend);
    float error = inverseTangent(turn.y, turn.x);
    float size = abs(error);
    float secant = size > kMaxBendError ? kMaxBendError / size : 1.0;
    float value = clamp(error, -kMaxBendError, kMaxBendError);
    float stiffness = implicit.modulus[kBend] / bend.geometry *
        min(1.0, kMostSteepness * bend.steepness / max(steepest, 1e-30));
    stiffness = boundedFirmness(stiffness, dot(squares, vec4(x0.w, x1.w, x2.w, x3.w)));
    float root = slivers ? 0.0 : sqrt(stiffness * (secant + implicit.damping));
    uint at = first + 4u * index;
    storeFactor(at, vec4(root * g0, 0.0));
    storeFactor(at + 1u, vec4(root * g1, 0.0));
    storeFactor(at + 2u, vec4(-root * a, 0.0));
    storeFactor(at + 3u, vec4(-root * b, 0.0));
    setPull(at, root > 0.0 ? stiffness * value / root : 0.0);
}
#else
// An ISPC: see constraints/ispc.glsl and ConstraintPull.
void setFactors(uint index, uint first) {
    uvec4 corners = fetch(records, 2u * index);
    vec4 rest = uintBitsToFloat(fetch(records, 2u * index + 1u));  // b1, b2, length, geometry
    float b0 = 1.0 - rest.x - rest.y;
    vec4 x = fetch(positions, corners.x);
    vec4 a = fetch(positions, corners.y);
    vec4 b = fetch(positions, corners.z);
    vec4 c = fetch(positions, corners.w);
    vec3 span = b0 * (x.xyz - a.xyz) + rest.x * (x.xyz - b.xyz) + rest.y * (x.xyz - c.xyz);
    float moved = x.w + b0 * b0 * a.w + rest.x * rest.x * b.w + rest.y * rest.y * c.w;
    float stiffness = boundedFirmness(implicit.modulus[kIspc] / rest.w, moved);
    Spring spring = springOf(span, rest.z, stiffness);
    uint at = first + 4u * index;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -b0);
    setFactor(at + 2u, spring, -rest.x);
    setFactor(at + 3u, spring, -rest.y);
    setPull(at, spring.pull);
}
#endif

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < numbers.x) setFactors(index, numbers.y);
}
