#pragma once

namespace kerf::render {

/// What the light tier leaves out: multisampling, the soft edge of the shadow, ambient occlusion.
enum class Quality { light, full };

}  // namespace kerf::render
