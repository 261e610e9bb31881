// How a vertex that moves ends a step: X += way, v = (X - from) / s exp(-c h). `shift`: of its
// piece (leave.comp).
STATE_TEXELS(kPositionsBinding) before;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kFirstWayBinding) firstWays;

struct Ended {
    vec3 place;
    vec3 velocity;
};

Ended endOf(uint v, vec3 shift) {
    vec3 way = fetch(ways, v).xyz + shift;
    vec3 last = way - (implicit.rest / implicit.stage) * fetch(firstWays, v).xyz;
    return Ended(fetch(before, v).xyz + way, (implicit.kept / implicit.stage) * last);
}
