// Whether two triangles meet, and how they answer to each other in the paper's contact. The
// includer declares `uniforms`.
struct MovingTriangle {
    vec3 a;
    vec3 b;
    vec3 c;
    vec3 velocity;      // mean of its corners [m/s]
    vec3 pieceMiddle;  // of the box of its piece [m]
};

// Whether the edge from p to q meets the triangle abc (Moeller and Trumbore, 1997), without a
// division: what is compared rounds alike everywhere.
bool meets(vec3 p, vec3 q, vec3 a, vec3 b, vec3 c) {
    vec3 way = q - p;
    vec3 first = b - a;
    vec3 second = c - a;
    vec3 across = cross(way, second);
    float scale = dot(first, across);
    vec3 from = p - a;
    vec3 over = cross(from, first);
    vec3 place = sign(scale) * vec3(dot(from, across), dot(way, over), dot(second, over));
    float size = abs(scale);
    return scale != 0.0 && place.x >= 0.0 && place.y >= 0.0 && place.x + place.y <= size &&
        place.z >= 0.0 && place.z <= size;
}

bool anEdgeMeets(MovingTriangle s, MovingTriangle t) {
    return meets(s.a, s.b, t.a, t.b, t.c) || meets(s.b, s.c, t.a, t.b, t.c) ||
        meets(s.c, s.a, t.a, t.b, t.c);
}

bool intersect(MovingTriangle s, MovingTriangle t) {
    return anEdgeMeets(s, t) || anEdgeMeets(t, s);
}

vec3 unit(vec3 v) {
    float size = length(v);
    return size > 0.0 ? v / size : vec3(0.0);
}

vec3 normalOf(MovingTriangle t) {
    return unit(cross(t.b - t.a, t.c - t.a));
}

// Where s gets out of t: along its normal, and against that of s. Where both face the same way,
// from the middle of the one piece to that of the other.
vec3 wayOut(MovingTriangle s, MovingTriangle t) {
    vec3 apart = normalOf(t) - normalOf(s);
    return unit(dot(apart, apart) > kFacesAlike ? apart : s.pieceMiddle - t.pieceMiddle);
}

// How s is to move in the time step; t moves the other way.
struct PaperResponse {
    vec3 loss;  // of velocity [m]
    vec3 push;  // of position alone [m]
};

PaperResponse responseOf(MovingTriangle s, MovingTriangle t) {
    vec3 apart = wayOut(s, t);
    vec3 relative = uniforms.interval * (s.velocity - t.velocity);
    float speed = length(relative);
    bool closing = -dot(relative, apart) > kStandsStill * uniforms.margin;
    vec3 against = closing ? -relative / speed : vec3(0.0);
    return PaperResponse(min(0.5 * speed, uniforms.reach) * against,
                         0.5 * uniforms.margin * apart);
}
