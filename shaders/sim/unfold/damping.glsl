#pragma once
// The damping of the springs that unfold, in this step. The includer declares `uniforms`.
float unfoldDamping() {
    return (uniforms.active_parts & kUnfoldFirmlyPart) != 0u ? kFirmUnfoldDamping : kUnfoldDamping;
}
