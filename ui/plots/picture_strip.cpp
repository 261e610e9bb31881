#include "ui/plots/picture_strip.h"

#include <imgui.h>

#include <stdexcept>

namespace kerf::ui {
namespace {

/// Where everything stands in a strip [pixels].
struct StripLayout {
    int pictureWidth = 0;
    int pictureHeight = 0;
    int margin = 0;  ///< around the strip and between pictures
    int line = 0;    ///< height of a line of text
    int captionHeight = 0;

    int left(std::size_t i) const { return margin + static_cast<int>(i) * (pictureWidth + margin); }
    int top() const { return margin + line + margin / 2; }
    int captionTop() const { return top() + pictureHeight + margin / 2; }
    int width(std::size_t count) const { return left(count); }
    int height() const { return captionTop() + captionHeight + margin; }
};

float heightOf(const std::string& text, int width) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, static_cast<float>(width)).y;
}

/// Needs the fonts of the painter.
StripLayout layOut(std::span<const StripPicture> pictures) {
    StripLayout layout;
    layout.pictureWidth = pictures.front().image.width;
    layout.pictureHeight = pictures.front().image.height;
    layout.line = static_cast<int>(std::ceil(ImGui::GetFontSize()));
    layout.margin = layout.line * 2 / 3;
    float highest = 0;
    for (const StripPicture& picture : pictures) {
        highest = std::max(highest, heightOf(picture.caption, layout.pictureWidth));
    }
    layout.captionHeight = static_cast<int>(std::ceil(highest));
    return layout;
}

void requireOneSize(std::span<const StripPicture> pictures) {
    const auto differs = [&](const StripPicture& picture) {
        return picture.image.width != pictures.front().image.width ||
               picture.image.height != pictures.front().image.height;
    };
    if (pictures.empty() || std::ranges::any_of(pictures, differs)) {
        throw std::invalid_argument("a strip needs pictures of one size");
    }
}

void drawTexts(const StripLayout& layout, const std::string& title,
               std::span<const StripPicture> pictures) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto at = [](int x, int y) {
        return ImVec2{static_cast<float>(x), static_cast<float>(y)};
    };
    draw.AddText(at(layout.margin, layout.margin), palette().text, title.c_str());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                     at(layout.left(i), layout.captionTop()), palette().text,
                     pictures[i].caption.c_str(), nullptr, static_cast<float>(layout.pictureWidth));
    }
}

}  // namespace

render::Image drawStrip(PicturePainter& painter, const std::string& title,
                        std::span<const StripPicture> pictures) {
    requireOneSize(pictures);
    painter.makeCurrent();
    const StripLayout layout = layOut(pictures);
    render::Image strip = painter.draw(layout.width(pictures.size()), layout.height(),
                                       [&] { drawTexts(layout, title, pictures); });
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        render::paste(strip, pictures[i].image, layout.left(i), layout.top());
    }
    return strip;
}

}  // namespace kerf::ui
