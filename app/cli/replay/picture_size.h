#pragma once

namespace kerf::app {

/// Size of a picture [px].
struct PictureSize {
    int width = 1280;
    int height = 720;
};

}  // namespace kerf::app
