// Warm key, cool sky, dim warm bounce from the ground.
uniform vec3 keyDirection;  // towards the light, unit

const vec3 kKeyColor = vec3(1.0, 0.88, 0.72) * 2.0;
const vec3 kSkyColor = vec3(0.56, 0.68, 0.92) * 0.52;
const vec3 kFillColor = vec3(0.90, 0.95, 1.0);
const vec3 kGroundColor = vec3(0.42, 0.36, 0.33) * 0.30;

vec3 ambientLight(vec3 n) { return mix(kGroundColor, kSkyColor, 0.5 + 0.5 * n.y); }
