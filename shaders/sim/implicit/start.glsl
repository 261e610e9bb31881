// Where a stage begins: the volume that is missing, then as far along the motion as is best, with
// its change of volume taken out.
layout(std430, binding = kPiecesBinding) readonly buffer Records { PieceRecord records[]; };
layout(std430, binding = kBlockSumsBinding) readonly buffer Volumes { float volumes[]; };

float missingVolume(PieceRecord record) {
    float volume = 0.0;
    for (uint k = 0u; k < record.block_count; ++k) {
        volume += volumes[record.first_block + k];
    }
    return record.target_volume - volume;
}

Line lineOf(uint index) {
    ImplicitPiece piece = pieceAt(index);
    TwoSums pressed = sumOfProducts(piece, kPressureSlot);
    TwoSums moved = sumOfProducts(piece, kStartSlot);
    float gamma = pressed.first.z;        // dV/dp . pressure
    float kappa = pressed.first.x;        // pressure . its image
    float pressureImage = moved.first.y;  // pressure . image
    float missing = ratio(missingVolume(records[index]), gamma);
    float swelling = -ratio(moved.first.z, gamma);
    float along = pressureImage + swelling * kappa;
    float curve = moved.first.x + swelling * (pressureImage + along);
    float slope = moved.first.w + swelling * moved.second.x - missing * along;
    vec2 pressure = vec2(ratio(moved.second.x - missing * kappa, gamma), ratio(along, gamma));
    return Line(curve, slope, pressure, missing, swelling);
}
