// Where a stage begins: the volume that is missing, then as far along the motion as is best, with
// its change of volume taken out.
layout(std430, binding = kPiecesBinding) readonly buffer Records { PieceRecord records[]; };
layout(std430, binding = kBlockSumsBinding) readonly buffer Volumes { VolumeSum volumes[]; };

struct Start {
    float missing;   // of the pressure: brings the volume back
    float alpha;     // of the motion
    float swelling;  // of the pressure, in the motion
    float pressure;  // of dV/dp, in the residual
};

float missingVolume(PieceRecord record) {
    float volume = 0.0;
    for (uint k = 0u; k < record.block_count; ++k) {
        volume += volumes[record.first_block + k].volume;
    }
    return record.target_volume - volume;
}

Start startOf(uint index) {
    ImplicitPiece piece = pieceAt(index);
    TwoSums pressed = sumOfProducts(piece, kPressureSlot);
    TwoSums moved = sumOfProducts(piece, kStartSlot);
    float gamma = pressed.first.z;        // dV/dp . pressure
    float kappa = pressed.first.x;        // pressure . its image
    float pressureImage = moved.first.y;  // pressure . image
    float missing = ratio(missingVolume(records[index]), gamma);
    float swelling = -ratio(moved.first.z, gamma);
    float curve =
        moved.first.x + 2.0 * swelling * pressureImage + swelling * swelling * kappa;
    float slope = moved.first.w + swelling * moved.second.x -
        missing * (pressureImage + swelling * kappa);
    float alpha = ratio(slope, curve);
    float left = moved.second.x - missing * kappa - alpha * (pressureImage + swelling * kappa);
    return Start(missing, alpha, swelling, ratio(left, gamma));
}
