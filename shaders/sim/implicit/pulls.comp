// What hands, forces and bonds do to their vertices, as rows of contact that hold whatever they
// bear: a hand by a critically damped spring, which has the target of the stage; see sim/pull.comp.
// A force joins the others.
// Numbers: the first row, how many pulls, when the stage ends [s, as bits], 1 where the step
// begins. One thread per pull; no two name one vertex. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kPullsBinding) readonly buffer Pulls { PullRecord pulls[]; };
layout(std430, binding = kParentsBinding) coherent buffer Parents { uint parents[]; };
layout(std430, binding = kRowStatesBinding) writeonly buffer States { vec4 states[]; };
layout(std430, binding = kPullRowsBinding) writeonly buffer Rows { vec4 rows[]; };
layout(std430, binding = kPullVerticesBinding) writeonly buffer Vertices { uvec4 vertices[]; };
layout(std430, binding = kForceBinding) buffer Force { vec4 force[]; };
#include "sim/implicit/join.glsl"

const float kUnbroken = 1e30;
uint row = numbers.x + gl_GlobalInvocationID.x;
float stageEnd = uintBitsToFloat(numbers.z);
bool begins = numbers.w != 0u;

// `other`: the piece of the other vertex, if there is one.
void setRow(vec3 slip, float stiffness, uint piece, float other) {
    rows[kRowTexels * row] = vec4(vec3(0.0), float(piece));
    rows[kRowTexels * row + 1u] = vec4(slip, stiffness);
    rows[kRowTexels * row + 2u] = vec4(other, other < 0.0 ? 0.0 : -1.0, 0.0, 0.0);
    rows[kRowTexels * row + 3u] = vec4(0.0);
    states[2u * row] = vec4(slip, 1.0);
    states[2u * row + 1u] = vec4(kUnbroken, 0.0, 0.0, kUndamped);
}

void pullByHand(PullRecord pull, vec4 x, uint piece) {
    bool leads = pull.leads == 1u;
    vec3 motion = vec3(pull.motion_x, pull.motion_y, pull.motion_z);
    vec3 target = vec3(pull.target_x, pull.target_y, pull.target_z) - implicit.step * motion;
    float spring = leads ? 0.0 : kPullRate * kPullRate;
    float rate = leads ? kLeadStrength * implicit.inertia
                       : spring + 4.0 * kPullRate / implicit.step;
    vec3 slip = (spring / rate) * (x.xyz - target) - stageEnd * motion;
    setRow(slip, massOf(x.w) * rate, piece, kOfObstacle);
    vertices[row] = uvec4(pull.vertex);
}

// Its force is that at the opening which it will have: where it falls, that of now would be too
// much.
void pullByBond(PullRecord pull, vec4 x, uint piece) {
    uint other = pull.leads - kFirstBond;
    if (links[other].piece == kNoPiece) return;
    vec3 gap = x.xyz - fetch(positions, other).xyz;
    vec3 way = stageEnd * (fetch(velocities, pull.vertex).xyz - fetch(velocities, other).xyz);
    float widest = max(pull.motion_z, length(gap + way));
    float stiffness = pull.motion_x * max(1.0 / widest - 1.0 / pull.motion_y, 0.0);
    setRow(gap, stiffness, piece, float(links[other].piece));
    vertices[row] = uvec4(pull.vertex, other, pull.vertex, pull.vertex);
    if (begins) join(piece, links[other].piece);
}

void pullBy(PullRecord pull) {
    vec4 x = fetch(positions, pull.vertex);
    uint piece = links[pull.vertex].piece;
    if (!(x.w > 0.0) || piece == kNoPiece) return;
    if (pull.leads >= kFirstBond) {
        pullByBond(pull, x, piece);
    } else if (pull.leads != kForcePull) {
        pullByHand(pull, x, piece);
    } else if (!begins && stageEnd < implicit.step) {
        vec3 acceleration = vec3(pull.motion_x, pull.motion_y, pull.motion_z);
        force[pull.vertex] += vec4(massOf(x.w) * acceleration, 0.0);
    }
}

void main() {
    if (gl_GlobalInvocationID.x >= numbers.y) return;
    rows[kRowTexels * row + 1u] = vec4(0.0);
    pullBy(pulls[gl_GlobalInvocationID.x]);
}
