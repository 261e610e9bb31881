// How a group of vertices that lie together descends the tree together, down to nodes that lie near
// any of them. The includer declares what it reads, the numbers (roots, leaves, ...),
// rangeAt(way): up to where a vertex looks for what moves against it by `way`, and
// lookThroughLeaves(own).
// The vertex that searches.
struct Searcher {
    uint vertex;
    uint piece;
    vec3 place;
    vec3 velocity;
    vec3 skin;  // its normals
    vec3 wall;
    uint kinds;    // what its triangles are
    uint opposed;  // where the normals of triangles that it may touch can point to; 0: none
};
Searcher self;

// Vertices that search together, or one of them.
struct Bounds {
    vec3 low;
    vec3 high;
    vec3 slowest;
    vec3 fastest;
    uint opposed;
    float share;  // of the range, from where on nothing is among the nearest
};

bool isWithin(Bounds b, uint node, float squareOfRange) {
    uvec4 low = fetch(nodes, 4u * node);
    vec3 high = uintBitsToFloat(fetch(nodes, 4u * node + 1u).xyz);
    vec3 apart = max(max(uintBitsToFloat(low.xyz) - b.high, b.low - high), vec3(0.0));
    return (low.w & b.opposed) != 0u && dot(apart, apart) <= squareOfRange;
}

// What rounding may add to a way, as a factor.
const float kSlack = 1.001;

// The square of up to where something in the node counts; below 0: nothing does.
float squareOfRange(Bounds b, uint node) {
    vec3 slowest = uintBitsToFloat(fetch(nodes, 4u * node + 2u).xyz);
    vec3 fastest = uintBitsToFloat(fetch(nodes, 4u * node + 3u).xyz);
    float range = kSlack * rangeAt(length(max(fastest - b.slowest, b.fastest - slowest)));
    return range * abs(range);
}

const uint kTaken = kSearchGroup / kTreeFan;  // nodes whose children are looked at at once
const uint kMostNodes = 16u * kSearchGroup;   // as many levels as there will ever be
shared uint stack[kMostNodes];
shared uint stackSize;
shared uint leafCount;
shared vec3 lows[kSearchGroup];
shared vec3 highs[kSearchGroup];
shared vec3 slowest[kSearchGroup];
shared vec3 fastest[kSearchGroup];
shared uint directions[kSearchGroup];

// Leaves near the group, and the square of up to where it looks there. An image, of which llvmpipe
// reads eight at once; shared memory it reads one by one.
layout(binding = kContactGroupLeavesUnit, rg32ui) coherent uniform uimageBuffer groupLeaves;

int placeOfLeaf(uint i) { return int(gl_WorkGroupID.x * kMostGroupLeaves + i); }
uvec2 leafAt(uint i) { return imageLoad(groupLeaves, placeOfLeaf(i)).xy; }
void setLeaf(uint i, uint node, float range) {
    imageStore(groupLeaves, placeOfLeaf(i), uvec4(node, floatBitsToUint(range), 0u, 0u));
}

void lookThroughLeaves(inout Bounds own);

Bounds ownBounds() {
    bool sane = within(self.velocity, kAnySpeed);
    bool searches = self.opposed != 0u;
    return Bounds(searches ? self.place : vec3(kNothing), searches ? self.place : vec3(-kNothing),
                  sane ? self.velocity : vec3(-kAnySpeed), sane ? self.velocity : vec3(kAnySpeed),
                  self.opposed, 1.0);
}

Bounds boundsOfGroup(Bounds own) {
    uint thread = gl_LocalInvocationID.x;
    lows[thread] = own.low;
    highs[thread] = own.high;
    slowest[thread] = own.opposed != 0u ? own.slowest : vec3(kAnySpeed);
    fastest[thread] = own.opposed != 0u ? own.fastest : vec3(-kAnySpeed);
    directions[thread] = own.opposed;
    for (uint count = kSearchGroup / 2u; count > 0u; count /= 2u) {
        barrier();
        if (thread < count) {
            lows[thread] = min(lows[thread], lows[thread + count]);
            highs[thread] = max(highs[thread], highs[thread + count]);
            slowest[thread] = min(slowest[thread], slowest[thread + count]);
            fastest[thread] = max(fastest[thread], fastest[thread + count]);
            directions[thread] |= directions[thread + count];
        }
    }
    barrier();
    return Bounds(lows[0], highs[0], slowest[0], fastest[0], directions[0], 1.0);
}

// Puts a node where it belongs if it is near the group.
void sort(Bounds group, uint node) {
    float range = squareOfRange(group, node);
    if (!isWithin(group, node, range)) return;
    if (node < numbers.y) {
        setLeaf(atomicAdd(leafCount, 1u), node, range);
    } else {
        stack[atomicAdd(stackSize, 1u)] = node;
    }
}

// Looks at the children of the last few nodes on the stack, so that it never grows long.
void descend(Bounds group) {
    uint thread = gl_LocalInvocationID.x;
    uint size = stackSize;
    uint taken = min(size, kTaken);
    uint child = kNoVertex;
    if (thread / kTreeFan < taken) {
        uint node = stack[size - 1u - thread / kTreeFan];
        child = fetch(nodes, 4u * node + 1u).w + thread % kTreeFan;
    }
    barrier();
    if (thread == 0u) stackSize = size - taken;
    barrier();
    if (child != kNoVertex) sort(group, child);
    memoryBarrierImage();
    barrier();
}

void search(Bounds own, Bounds group) {
    uint thread = gl_LocalInvocationID.x;
    if (thread == 0u) stackSize = leafCount = 0u;
    barrier();
    if (thread < kTreeFan) sort(group, numbers.x + thread);
    memoryBarrierImage();
    barrier();
    while (stackSize + leafCount > 0u) {
        while (stackSize > 0u && leafCount + kSearchGroup <= kMostGroupLeaves) {
            descend(group);
        }
        lookThroughLeaves(own);
        barrier();
        if (thread == 0u) leafCount = 0u;
        barrier();
    }
}

void takeVertex() {
    uint v = fetch(order, gl_GlobalInvocationID.x).x;
    self = Searcher(v, kNoPiece, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0u, 0u);
    if (v >= uniforms.vertex_count) return;
    self.piece = links[v].piece;
    self.place = fetch(positions, v).xyz;
    self.velocity = fetch(velocities, v).xyz;
    vec4 normal = fetch(normals, 2u * v);
    self.skin = normal.xyz;
    self.wall = fetch(normals, 2u * v + 1u).xyz;
    self.kinds = uint(normal.w);
    if (self.piece != kNoPiece && pieces[self.piece].constrained != 0u &&
        within(self.place, kNothing)) {
        self.opposed = opposedBins(self.skin) | opposedBins(self.wall);
    }
}
