// Pictures of a lit ball: the colour is that of the ball where it faces the same way. The same from
// wherever one looks, and free of shadows: for shape alone. MATCAP: 1 clay, 2 steel, 3 normals.

vec3 seenNormal(vec3 n, vec3 v) {
    vec3 up = vec3(0, 1, 0);
    vec3 right = cross(up, v);
    right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1, 0, 0);
    return vec3(dot(n, right), dot(n, cross(v, right)), dot(n, v));
}

vec3 matcap(vec3 albedo, vec3 world, vec3 v) {
    vec3 n = seenNormal(world, v);
#if MATCAP == 1
    float key = max(dot(n, normalize(vec3(-0.45, 0.65, 0.62))), 0.0);
    float rim = pow(1.0 - clamp(n.z, 0.0, 1.0), 3.0);
    vec3 low = vec3(0.055, 0.030, 0.028);
    vec3 high = vec3(0.86, 0.56, 0.44);
    vec3 c = mix(low, high, 0.12 + 0.88 * key * key * (0.4 + 0.6 * key));
    return c * (0.55 + 1.3 * albedo.g) + 0.16 * rim * vec3(0.5, 0.6, 0.8) * max(n.y + 0.6, 0.0);
#elif MATCAP == 2
    float bands = 0.5 + 0.5 * sin(7.0 * n.y + 2.2 * n.x * n.x);
    float key = pow(max(dot(n, normalize(vec3(-0.35, 0.6, 0.72))), 0.0), 18.0);
    float rim = pow(1.0 - clamp(n.z, 0.0, 1.0), 2.5);
    return vec3(0.62, 0.68, 0.76) * (0.08 + 0.40 * bands * bands + 0.5 * rim) * (0.7 + albedo.g) +
        1.2 * key;
#else
    vec3 c = 0.5 + 0.5 * n;
    return 0.75 * c * c;
#endif
}
