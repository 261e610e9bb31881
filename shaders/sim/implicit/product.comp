// The matrix M / s^2 + (1 + 2 beta / h) K times a vector, row by row, and what follows for the
// iteration:
//   p = z - pressure (dV/dp . z) / (dV/dp . pressure) + beta p,  image = A p
// of which A p is summed up from A z and the images before. With OF_START p is there already: its
// answer to dV/dp, or, with OF_MOTION, the motion of the body.
// Numbers: the slot. One group for each page, of the vertices of its piece. A storage barrier
// follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
STATE_TEXELS(kPositionsBinding) positions;
RECORD_PAIRS(kRowsUnit) rows;
STATE_TEXELS(kBlocksUnit) blocks;
RECORD_WORDS(kRowOrderUnit) rowOrder;
RECORD_PAIRS(kPageTableUnit) pageTable;
STATE_TEXELS(kResidualBinding) residuals;
STATE_TEXELS(kPressureBinding) pressures;
STATE_TEXELS(kPressureImageBinding) pressureImages;
STATE_TEXELS(kGradientsBinding) gradients;
STATE_TEXELS(kAnswerBinding) answers;
STATE_TEXELS(kDirectionBinding) directions;
STATE_TEXELS(kImageBinding) images;
layout(std430, binding = kDirectionBinding) writeonly buffer Directions { vec4 newDirections[]; };
layout(std430, binding = kImageBinding) writeonly buffer Images { vec4 newImages[]; };
layout(std430, binding = kProductSumsBinding) writeonly buffer Sums { vec4 newSums[]; };

#ifdef OF_START
vec3 factorOf(uint v) { return fetch(directions, v).xyz; }
#else
vec3 factorOf(uint v) { return fetch(answers, v).xyz; }
#endif

// What moves as a whole is not strained: a block on the diagonal of K is what the others of its row
// lack. So they take how much farther than this vertex the others go, since the sum of rounded
// blocks would drag walls, whose springs are short, by more than their mass.
vec3 rowTimes(uint v, float inverseUnitMass) {
    uvec2 range = fetch(rows, v).xy;
    vec3 own = factorOf(v);
    vec3 sum = implicit.inertia * massOf(inverseUnitMass) * own;
    for (uint k = range.x; k < range.y; ++k) {
        vec4 x = fetch(blocks, 3u * k);
        vec3 y = fetch(blocks, 3u * k + 1u).xyz;
        vec3 z = fetch(blocks, 3u * k + 2u).xyz;
        vec3 factor = factorOf(uint(x.w)) - own;
        sum += vec3(dot(x.xyz, factor), dot(y, factor), dot(z, factor));
    }
    return sum;
}

// What a vertex adds to the sums of its page.
struct Share {
    vec4 products;
    float pressed;
};

// How the iteration goes on.
struct Turn {
    float beta;
    float pressure;
    float size;
    float gamma;
    float scale;
    bool done;
};

Share multiply(uint v, Turn turn) {
    float inverseUnitMass = fetch(positions, v).w;
    vec3 image = inverseUnitMass > 0.0 ? rowTimes(v, inverseUnitMass) : vec3(0.0);
    vec3 direction = factorOf(v);
    vec3 pressure = fetch(pressures, v).xyz;
#ifndef OF_START
    direction += turn.beta * fetch(directions, v).xyz - turn.pressure * pressure;
    image += turn.beta * fetch(images, v).xyz - turn.pressure * fetch(pressureImages, v).xyz;
    if (turn.done) {
        direction = vec3(0.0);
        image = vec3(0.0);
    }
    newDirections[v] = vec4(direction, 0.0);
#endif
    newImages[v] = vec4(image, 0.0);
    vec3 residual = fetch(residuals, v).xyz;
    return Share(vec4(dot(direction, image), dot(pressure, image),
                      dot(fetch(gradients, v).xyz, direction), dot(direction, residual)),
                 dot(pressure, residual));
}

Share shareOf(uint place, Turn turn) {
    uint v = fetch(rowOrder, place).x;
    return v == kNoVertex ? Share(vec4(0.0), 0.0) : multiply(v, turn);
}

#ifdef LOAD_IMAGES  // groups of as many threads as rows
// A thread has all places of its row.
void leaveRows(uint page, Turn turn) {
    TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
    for (uint place = gl_LocalInvocationID.x; place < kPageSize; place += GROUP) {
        Share share = shareOf(kPageSize * page + place, turn);
        sums.first += share.products;
        sums.second.x += share.pressed;
    }
    leaveRow(gl_LocalInvocationID.x, sums);
}
#else
shared vec4 products[kPageSize];
shared float pressed[kPageSize];

void leaveRows(uint page, Turn turn) {
    for (uint place = gl_LocalInvocationID.x; place < kPageSize; place += GROUP) {
        Share share = shareOf(kPageSize * page + place, turn);
        products[place] = share.products;
        pressed[place] = share.pressed;
    }
    barrier();
    for (uint row = gl_LocalInvocationID.x; row < kRows; row += GROUP) {
        TwoSums sums = TwoSums(vec4(0.0), vec4(0.0));
        for (uint place = row; place < kPageSize; place += kRows) {
            sums.first += products[place];
            sums.second.x += pressed[place];
        }
        leaveRow(row, sums);
    }
}
#endif

void main() {
    uvec2 page = fetch(pageTable, gl_WorkGroupID.x).xy;  // its number, its piece
#ifdef OF_MOTION
    float gamma = sumOfProducts(pieceAt(page.y), kPressureSlot).first.z;
    Turn turn = Turn(0.0, 0.0, 0.0, gamma, 0.0, false);
#elif defined(OF_START)
    Turn turn = Turn(0.0, 0.0, 0.0, 0.0, 0.0, false);
#else
    vec4 course = fetch(courses, kCourseTexels * page.y);
    vec4 rest = fetch(courses, kCourseTexels * page.y + 1u);
    if (rest.z != 0.0) return;  // has ended
    Turn turn = Turn(course.x, course.y, course.z, course.w, rest.x, rest.y != 0.0);
#endif
    leaveRows(page.x, turn);
    TwoSums sums = sumOfRows();
    if (gl_LocalInvocationID.x == 0u) {
        uint at = productsAt(numbers.x, gl_WorkGroupID.x);
        newSums[at] = sums.first;
        newSums[at + 1u] = vec4(sums.second.x, turn.size, turn.gamma, turn.scale);
    }
}
