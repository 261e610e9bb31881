#include "render/scene/skin_paint.h"

namespace kerf::render {
namespace {

std::uint32_t halves(float low, float high) {
    const auto bits = [](float value) {
        const float bounded = std::clamp(value, 0.0F, 65000.0F);  // halves end there
        return std::uint32_t{Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(bounded))};
    };
    return bits(low) | bits(high) << 16U;
}

shared::SkinCorner cornerOf(const Eigen::Vector2f& uv, const Eigen::Vector4f& tint, bool own) {
    return {uv.x(), uv.y(), halves(tint.x(), tint.y()), halves(tint.z(), own ? 1 : 0)};
}

/// Tells what of an appearance a triangle is drawn with.
class Paint {
  public:
    Paint(bool colored, const Appearance* appearance)
        : colored_(colored), appearance_(appearance) {}

    int imageOf(const PaintedTriangle& painted) const {
        const SurfaceMaterial* material = materialOf(painted.attributes);
        return material == nullptr ? -1 : material->image;
    }
    shared::SkinRecord record(const PaintedTriangle& painted) const {
        const TriangleAttributes& from = painted.attributes;
        const SurfaceMaterial* material = materialOf(from);
        const Eigen::Vector4f base =
            material == nullptr ? Eigen::Vector4f(Eigen::Vector4f::Ones()) : shownColor(*material);
        const bool own = material != nullptr || colored_;
        const auto corner = [&](int i) {
            return cornerOf(from.uvs[i], base.cwiseProduct(from.colors[i]), own);
        };
        return {painted.triangle, corner(0), corner(1), corner(2)};
    }

  private:
    const SurfaceMaterial* materialOf(const TriangleAttributes& attributes) const {
        const bool has = appearance_ != nullptr && attributes.material >= 0;
        return has ? &appearance_->materials[attributes.material] : nullptr;
    }

    bool colored_;
    const Appearance* appearance_;
};

}  // namespace

SkinPaint paintSkin(const std::vector<PaintedTriangle>& skin, bool colored,
                    std::shared_ptr<const Appearance> appearance) {
    const Paint paint(colored, appearance.get());
    std::vector<std::pair<int, const PaintedTriangle*>> byImage;
    byImage.reserve(skin.size());
    for (const PaintedTriangle& painted : skin) {
        byImage.emplace_back(paint.imageOf(painted), &painted);
    }
    std::ranges::stable_sort(byImage, {}, &std::pair<int, const PaintedTriangle*>::first);
    SkinPaint out;
    out.records.reserve(skin.size());
    for (const auto& [image, painted] : byImage) {
        if (out.ranges.empty() || out.ranges.back().image != image) {
            out.ranges.push_back({image, static_cast<std::uint32_t>(out.records.size()), 0});
        }
        ++out.ranges.back().count;
        out.records.push_back(paint.record(*painted));
    }
    out.appearance = std::move(appearance);
    return out;
}

}  // namespace kerf::render
