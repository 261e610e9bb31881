// How far a bend is folded, from its error vector (bend_angle.glsl): 0 to 1.
float foldOf(vec2 turn) {
    float size = length(turn);
    float cosine = size > 0.0 ? turn.x / size : 1.0;
    return clamp((kFoldBegins - cosine) / (kFoldBegins - kFoldEnds), 0.0, 1.0);
}
