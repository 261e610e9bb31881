// values[i] = i * factor + OFFSET, one thread per value.
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
uniform uint count;
uniform uint factor;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    values[i] = i * factor + OFFSET;
}
