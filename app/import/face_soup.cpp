#include "app/import/face_soup.h"

#include <spdlog/fmt/fmt.h>

#include "app/files/import/import_answer.h"
#include "app/files/io/errors.h"
#include "app/import/polygon_triangles.h"
#include "render/scene/body_look.h"
#include "sim/base/math.h"
#include "sim/base/placement.h"

namespace kerf::app {

void FaceSoup::enterObject(const std::string& name) {
    if (objectNames_.empty() && !ends_.empty()) {
        objectNames_.emplace_back();  // of the faces before
    }
    const auto [place, isNew] =
        objectNumbers_.try_emplace(name, static_cast<int>(objectNames_.size()));
    object_ = place->second;
    if (isNew) {
        objectNames_.push_back(name);
    }
}

void FaceSoup::beginObject(const std::string& name) {
    const std::string wanted = name.empty() ? "object" : name;
    std::string free = wanted;
    for (std::size_t number = objectNames_.size() + 1; objectNumbers_.contains(free); ++number) {
        free = wanted + " " + std::to_string(number);
    }
    enterObject(free);
}

void FaceSoup::addCorner(int vertex, int uv) {
    corners_.push_back(vertex);
    cornerUvs_.push_back(uv);
}

void FaceSoup::endFace(int material) {
    const std::size_t first = ends_.empty() ? 0 : ends_.back();
    if (corners_.size() < first + 3) {
        corners_.resize(first);
        cornerUvs_.resize(first);
        return;
    }
    ends_.push_back(corners_.size());
    materials_.push_back(material);
    hasMaterials_ |= material >= 0;
    objects_.push_back(object_);
}

/// Every other triangle is turned over.
void FaceSoup::addStrips(const std::vector<double>& corners) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < 0) {
            begin = i + 1;
        } else if (i >= begin + 2) {
            const std::size_t turned = (i - begin) % 2;
            for (const std::size_t k : {i - 2 + turned, i - 1 - turned, i}) {
                addCorner(cornerOf(corners[k]));
            }
            endFace();
        }
    }
}

TriangleSoup FaceSoup::triangles() {
    requireCorners();
    std::size_t first = 0;
    for (std::size_t face = 0; face < ends_.size(); ++face) {
        for (const auto& [a, b, c] : divided(first, ends_[face])) {
            const int from = static_cast<int>(first);
            addTriangle(face, {from + a, from + b, from + c});
        }
        first = ends_[face];
    }
    if (soup_.triangles.empty()) {
        throw InputError("there is no surface in it");
    }
    soup_.positions = std::move(positions);
    return std::move(soup_);
}

/// A file whose corners name texture coordinates, and which has none at all, has no texture.
void FaceSoup::requireCorners() const {
    const auto require = [](const std::vector<int>& named, std::size_t count, int least,
                            const char* what) {
        const auto missing = std::ranges::find_if(
            named, [&](int i) { return i < least || i >= static_cast<long long>(count); });
        if (missing != named.end()) {
            throw InputError(std::string("a face names ") + what + " " + std::to_string(*missing) +
                             ", counted from 0, and there are " + std::to_string(count));
        }
    };
    require(corners_, positions.size(), 0, "vertex");
    if (!uvs.empty()) {
        require(cornerUvs_, uvs.size(), kNone, "texture coordinate");
    }
}

/// As numbers of corners.
std::vector<Triangle> FaceSoup::divided(std::size_t first, std::size_t end) const {
    std::vector<Triangle> triangles;
    if (end > first + 3) {
        std::vector<Vec3> places;
        for (const int vertex : std::span(corners_).subspan(first, end - first)) {
            places.push_back(positions[vertex]);
        }
        triangles = triangulatePolygon(places);
    }
    const bool fan = triangles.empty();
    for (int i = 2; fan && i < static_cast<int>(end - first); ++i) {
        triangles.push_back({0, i - 1, i});
    }
    return triangles;
}

void FaceSoup::addTriangle(std::size_t face, const Triangle& corners) {
    const auto [a, b, c] = corners;
    soup_.triangles.push_back({vertexAt(a), vertexAt(b), vertexAt(c)});
    if (!uvs.empty() || !vertexUvs.empty()) {
        soup_.skin.uvs.push_back({uvAt(a), uvAt(b), uvAt(c)});
    }
    if (!vertexColors.empty() || !faceColors.empty()) {
        const auto color = [&](int corner) { return colorAt(face, corners_[corner]); };
        soup_.skin.colors.push_back({color(a), color(b), color(c)});
    }
    if (hasMaterials_) {
        soup_.skin.materials.push_back(materials_[face]);
    }
    if (!objectNames_.empty()) {
        soup_.objects.push_back(objects_[face]);
    }
}

int FaceSoup::vertexAt(std::size_t corner) const {
    const int own = corners_[corner];
    return static_cast<std::size_t>(own) < aliases.size() ? aliases[own] : own;
}

Eigen::Vector2f FaceSoup::uvAt(std::size_t corner) const {
    const auto in = [](const std::vector<Vec2>& list, int number) {
        return static_cast<std::size_t>(number) < list.size() ? list[number] : Vec2(Vec2::Zero());
    };
    const int own = cornerUvs_[corner];
    return (own >= 0 ? in(uvs, own) : in(vertexUvs, corners_[corner])).cast<float>();
}

Eigen::Vector4f FaceSoup::colorAt(std::size_t face, int vertex) const {
    const std::vector<Eigen::Vector4f>& list = vertexColors.empty() ? faceColors : vertexColors;
    const std::size_t number = vertexColors.empty() ? face : vertex;
    return number < list.size() ? list[number] : Eigen::Vector4f(Eigen::Vector4f::Ones());
}

int cornerOf(double number) {
    const bool whole =
        number >= 0 && number < std::numeric_limits<int>::max() && number == std::floor(number);
    return whole ? static_cast<int>(number) : FaceSoup::kNone;
}

Eigen::Vector4f linearOf(const Eigen::Vector4d& display) {
    const Vec3f linear = render::toLinear(display.head<3>());
    return {linear.x(), linear.y(), linear.z(), static_cast<float>(display.w())};
}

void makeLinear(std::vector<Eigen::Vector4f>& display) {
    constexpr float kMostShare = 2;
    const bool bytes = std::ranges::any_of(
        display, [](const Eigen::Vector4f& color) { return color.maxCoeff() > kMostShare; });
    for (Eigen::Vector4f& color : display) {
        const Eigen::Vector4d shares = color.cast<double>() / (bytes ? 255 : 1);
        const double opacity = color.w() > kMostShare ? shares.w() : color.w();
        color = color == kNoColor ? Eigen::Vector4f(Eigen::Vector4f::Ones())
                                  : linearOf({shares.x(), shares.y(), shares.z(), opacity});
    }
}

void takeFaces(FaceSoup& faces, ImportedModel& model) {
    model.soup = faces.triangles();
    model.facts.objects = faces.objectNames();
}

void roundNearOrigin(TriangleSoup& soup) {
    if (originOf(boxOf(soup.positions)) == Vec3::Zero()) {
        std::ranges::transform(soup.positions, soup.positions.begin(), nearestFloats);
    }
}

void requireFineFloats(std::span<const Vec3> positions) {
    constexpr double kStep = 0x1p-24;       // of a float, as a share of it
    constexpr double kMostOfLength = 1e-3;  // that a step may be
    const Bounds bounds = boxOf(positions);
    if (bounds.empty()) {
        return;  // No number at all.
    }
    const double reach =
        std::max(bounds.high.cwiseAbs().maxCoeff(), bounds.low.cwiseAbs().maxCoeff());
    const double length = (bounds.high - bounds.low).maxCoeff();
    if (length > 0 && kStep * reach > kMostOfLength * length) {
        throw InputError(fmt::format(
            "it is {:.3g} long and reaches {:.3g} from the origin, where the 32-bit numbers in "
            "which this format is read are {:.1g} apart; export it as PLY or OBJ with all its "
            "digits, or nearer to the origin",
            length, reach, 2 * kStep * reach));
    }
}

}  // namespace kerf::app
