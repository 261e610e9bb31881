// Strips and bar charts of reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/support/gl_fixture.h"
#include "ui/plots/bar_chart.h"
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

class ReportPicturesTest : public test::GlTest {
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

TEST_F(ReportPicturesTest, BarsAreAsHighAsTheirValues) {
    BarChart chart{"rates", {{"paper", Hue::gray}, {"ours", Hue::blue}}, {}, 1};
    chart.groups = {{"one", {Bar{100, {}}, Bar{50, {}}}}, {"none", {std::nullopt, std::nullopt}}};
    const render::Image picture = drawBarChart(*painter, chart, 600, 400);
    painter->makeCurrent();
    const auto pixelsOf = [&](Hue hue) {
        const ImVec4 c = ImGui::ColorConvertU32ToFloat4(palette().of(hue));
        const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x * 255)); };
        return count(picture, {byte(c.x), byte(c.y), byte(c.z), 255});
    };
    EXPECT_GT(pixelsOf(Hue::blue), 1000);
    EXPECT_NEAR(pixelsOf(Hue::gray), 2.0 * pixelsOf(Hue::blue), 0.05 * pixelsOf(Hue::gray));
}

TEST_F(ReportPicturesTest, ABarShowsItsSpread) {
    const auto draw = [&](double low, double high) {
        const BarChart chart{"", {{"ours", Hue::blue}}, {{"one", {Bar{50, {{low, high}}}}}}, 1};
        return drawBarChart(*painter, chart, 400, 300);
    };
    EXPECT_NE(draw(40, 60).pixels, draw(45, 60).pixels);
}

}  // namespace
}  // namespace kerf::ui
