// Strips of pictures.

#include "ui/plots/picture_strip.h"

namespace kerf::ui {
namespace {

render::Image filled(int width, int height, std::uint8_t red) {
    render::Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        image.pixels.insert(image.pixels.end(), {red, 0, 0, 255});
    }
    return image;
}

using Colour = std::array<std::uint8_t, 4>;

Colour at(const render::Image& image, int x, int y) {
    const auto* pixel =
        &image
             .pixels[4 * (static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x))];
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

int count(const render::Image& image, const Colour& colour) {
    int found = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            found += at(image, x, y) == colour ? 1 : 0;
        }
    }
    return found;
}

class ReportPicturesTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        painter.emplace(Theme::light);
    }
    std::optional<PicturePainter> painter;  ///< made when there is a context
};

TEST_F(ReportPicturesTest, AStripHasEachPictureWhole) {
    const std::vector<StripPicture> pictures{{filled(60, 40, 10), "before"},
                                             {filled(60, 40, 20), "after\nstep 3"},
                                             {filled(60, 40, 30), ""}};
    const render::Image strip = drawStrip(*painter, "(a) Sphere", pictures);
    EXPECT_GT(strip.width, 180);
    EXPECT_GT(strip.height, 40 + 3 * 15) << "a title and two lines of caption";
    for (const StripPicture& picture : pictures) {
        const std::uint8_t red = picture.image.pixels.front();
        EXPECT_EQ(count(strip, {red, 0, 0, 255}), 60 * 40);
    }
}

TEST_F(ReportPicturesTest, AStripWritesItsCaptions) {
    const auto draw = [&](const std::string& caption) {
        return drawStrip(*painter, "title", std::vector{StripPicture{filled(60, 40, 9), caption}});
    };
    EXPECT_NE(draw("before").pixels, draw("beyond").pixels);
}

TEST_F(ReportPicturesTest, AStripTakesPicturesOfOneSizeOnly) {
    const std::vector<StripPicture> pictures{{filled(60, 40, 1), ""}, {filled(61, 40, 1), ""}};
    EXPECT_THROW(drawStrip(*painter, "", pictures), std::invalid_argument);
    EXPECT_THROW(drawStrip(*painter, "", {}), std::invalid_argument);
}

}  // namespace
}  // namespace kerf::ui
