#pragma once

#include "render/scene/image.h"

namespace kerf::render {

/// The perceived difference of each pixel when flipping between two pictures of one size: from 0
/// (invisible) to 1. Alpha is ignored. This is LDR-FLIP: Andersson, Nilsson, Akenine-Möller,
/// Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM
/// CGIT 3(2), 2020. The observer sees 67 pixels per degree: a display 0.7 m wide with 3840 pixels,
/// from 0.7 m. A pixel has an effect on those up to ten pixels away.
std::vector<float> flipErrors(const Image& a, const Image& b);

}  // namespace kerf::render
