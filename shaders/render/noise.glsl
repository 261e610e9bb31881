// Value noise from integer hashing: the same on every driver.
float hash(ivec3 p) {
    uvec3 q = uvec3(p) * uvec3(1597334673u, 3812015801u, 2798796415u);
    uint n = (q.x ^ q.y ^ q.z) * 1597334673u;
    n ^= n >> 15;
    return float(n >> 8) * (1.0 / 16777216.0);
}

float valueNoise(vec3 p) {
    ivec3 i = ivec3(floor(p));
    vec3 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec4 low = vec4(hash(i), hash(i + ivec3(1, 0, 0)), hash(i + ivec3(0, 1, 0)),
                    hash(i + ivec3(1, 1, 0)));
    vec4 high = vec4(hash(i + ivec3(0, 0, 1)), hash(i + ivec3(1, 0, 1)), hash(i + ivec3(0, 1, 1)),
                     hash(i + ivec3(1, 1, 1)));
    vec4 x = mix(low, high, f.z);
    vec2 y = mix(x.xy, x.zw, f.y);
    return mix(y.x, y.y, f.x);
}
