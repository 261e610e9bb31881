#include "render/scene/environment.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>
#include <stb_image.h>

#include <cstdlib>
#include <exception>
#include <stdexcept>

#include "gpu/data_path.h"

namespace kerf::render {

namespace {

constexpr int kMostSide = 8192;  // [px]
// Blurring takes samples of the panorama in so many columns and half as many rows.
constexpr int kSampleColumns = 64;
/// What a level weighs a direction by: the cosine to the middle of its lobe, squared so often. The
/// first is as sharp as its texels.
constexpr std::array<int, Environment::kLevels> kSquarings{0, 7, 5, 3, 1};
/// The roughness that each stands for: a Phong lobe of 2 / r^4 - 2 has the width of that of GGX.
constexpr std::array<float, Environment::kLevels> kRoughness{0.2F, 0.35F, 0.5F, 0.67F, 0.84F};

[[noreturn]] void refusePanorama(const std::filesystem::path& file, const std::string& why) {
    throw std::runtime_error(file.string() + ": " + why + ".");
}

/// Light from one direction, and how much of the sphere it stands for.
struct Sample {
    Vec3f direction;
    Vec3f light;
    float share = 0;
};

Vec3f directionOf(double u, double v) {
    const double around = 2 * std::numbers::pi * u;
    const double down = std::numbers::pi * v;
    return Vec3(-std::sin(around) * std::sin(down), std::cos(down),
                std::cos(around) * std::sin(down))
        .cast<float>();
}

/// Mean of the pixels of a cell of the panorama.
Vec3f meanOf(const Panorama& panorama, int column, int row, int columns, int rows) {
    Vec3f sum = Vec3f::Zero();
    int count = 0;
    const int right = std::max((column + 1) * panorama.width / columns, 1);
    const int bottom = std::max((row + 1) * panorama.height / rows, 1);
    for (int y = std::min(row * panorama.height / rows, bottom - 1); y < bottom; ++y) {
        for (int x = std::min(column * panorama.width / columns, right - 1); x < right; ++x) {
            sum += panorama.pixels[std::size_t(y) * panorama.width + x];
            ++count;
        }
    }
    return sum / float(count);
}

std::vector<Sample> samplesOf(const Panorama& panorama, int columns) {
    const int rows = columns / 2;
    std::vector<Sample> samples;
    for (int row = 0; row < rows; ++row) {
        const double v = (row + 0.5) / rows;
        const float share =
            float(std::sin(std::numbers::pi * v) * std::numbers::pi / (2.0 * columns * rows));
        for (int column = 0; column < columns; ++column) {
            samples.push_back({directionOf((column + 0.5) / columns, v),
                               meanOf(panorama, column, row, columns, rows), share});
        }
    }
    return samples;
}

/// The direction of a place on the unfolded octahedron, each -1 to 1 (environment.glsl).
Vec3f unfolded(float x, float z) {
    Vec3f d(x, 1 - std::abs(x) - std::abs(z), z);
    const float back = std::max(-d.y(), 0.0F);
    d.x() += d.x() >= 0 ? -back : back;
    d.z() += d.z() >= 0 ? -back : back;
    return d.normalized();
}

Vec3f blurred(const std::vector<Sample>& samples, const Vec3f& middle, int squarings) {
    Vec3f sum = Vec3f::Zero();
    float weights = 0;
    for (const Sample& sample : samples) {
        float weight = std::max(middle.dot(sample.direction), 0.0F);
        for (int i = 0; i < squarings; ++i) {
            weight *= weight;
        }
        weight *= sample.share;
        sum += weight * sample.light;
        weights += weight;
    }
    return sum / std::max(weights, 1e-30F);
}

/// The pixel in a direction.
Vec3f seen(const Panorama& panorama, const Vec3f& d) {
    const double u = std::atan2(-d.x(), d.z()) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(d.y(), -1.0F, 1.0F)) / std::numbers::pi;
    const int x = int((u < 0 ? u + 1 : u) * panorama.width);
    const int y = int(v * panorama.height);
    return panorama.pixels[std::size_t(std::clamp(y, 0, panorama.height - 1)) * panorama.width +
                           std::clamp(x, 0, panorama.width - 1)];
}

void append(std::vector<std::uint8_t>& bytes, const Vec3f& light) {
    for (const float c : light) {
        const float root = std::sqrt(std::clamp(c / kEnvironmentRange, 0.0F, 1.0F));
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * root)));
    }
    bytes.push_back(255);
}

/// The outermost texels lie on the seams, where each has a twin, so that filtering shows no seam.
template <class Look>
std::vector<std::uint8_t> square(int side, Look&& look) {
    std::vector<std::uint8_t> bytes;
    for (int z = 0; z < side; ++z) {
        for (int x = 0; x < side; ++x) {
            const auto place = [side](int i) { return 2 * float(i) / float(side - 1) - 1; };
            append(bytes, look(unfolded(place(x), place(z))));
        }
    }
    return bytes;
}

/// What a matt surface takes of light of constant and linear kind, the rest being small.
std::array<Vec3f, 4> mattOf(const std::vector<Sample>& samples) {
    std::array<Vec3f, 4> matt{Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero()};
    for (const Sample& sample : samples) {
        const Vec3f light = sample.share * sample.light;
        matt[0] += light;
        for (int axis = 0; axis < 3; ++axis) {
            matt[axis + 1] += 2 * sample.direction[axis] * light;
        }
    }
    return matt;
}

std::filesystem::path fileOf(bool bright) {
    const char* chosen = std::getenv("KERF_ENVIRONMENT");
    if (chosen != nullptr && *chosen != '\0') {
        return chosen;
    }
    return gpu::dataPath(bright ? "assets/environments/studio-bright.hdr"
                                : "assets/environments/studio-dark.hdr");
}

Panorama evenLight() {
    return {2, 1, {Vec3f::Constant(0.3F), Vec3f::Constant(0.3F)}};
}

Environment environmentOf(bool bright) {
    try {
        return prefilter(readPanorama(fileOf(bright)));
    } catch (const std::exception& problem) {
        spdlog::warn("{} The light is even instead.", problem.what());
        return prefilter(evenLight());
    }
}

}  // namespace

Panorama readPanorama(const std::filesystem::path& file) {
    Panorama out;
    int channels = 0;
    const std::string name = file.string();
    if (stbi_is_hdr(name.c_str()) == 0) {
        refusePanorama(file, "this is no panorama in Radiance's .hdr format that can be read");
    }
    if (stbi_info(name.c_str(), &out.width, &out.height, &channels) == 0 ||
        std::max(out.width, out.height) > kMostSide) {
        refusePanorama(file, "the panorama is damaged, or larger than 8192 pixels on a side");
    }
    const std::unique_ptr<float, void (*)(void*)> pixels(
        stbi_loadf(name.c_str(), &out.width, &out.height, &channels, 3), &stbi_image_free);
    if (!pixels) {
        refusePanorama(file, "the panorama is damaged or cut off");
    }
    for (std::size_t i = 0; i < std::size_t(out.width) * out.height; ++i) {
        out.pixels.emplace_back(pixels.get()[3 * i], pixels.get()[3 * i + 1],
                                pixels.get()[3 * i + 2]);
    }
    return out;
}

Environment prefilter(const Panorama& panorama) {
    const std::vector<Sample> samples = samplesOf(panorama, kSampleColumns);
    Environment out;
    out.matt = mattOf(samples);
    out.levels[0] = square(Environment::kSide, [&](const Vec3f& d) { return seen(panorama, d); });
    for (int level = 1; level < Environment::kLevels; ++level) {
        out.levels[level] = square(Environment::kSide >> level, [&](const Vec3f& d) {
            return blurred(samples, d, kSquarings[level]);
        });
    }
    return out;
}

MirrorLevel mirrorLevel(float roughness) {
    float level = 0;
    for (std::size_t i = 1; i < kRoughness.size(); ++i) {
        const float step = (roughness - kRoughness[i - 1]) / (kRoughness[i] - kRoughness[i - 1]);
        level += std::clamp(step, 0.0F, 1.0F);
    }
    const int nearest = static_cast<int>(std::lround(level));
    const auto side = static_cast<float>(Environment::kSide >> nearest);
    return {nearest, (side - 1) / side};
}

EnvironmentTexture::EnvironmentTexture(const Environment& environment)
    : id_(gpu::makeTexture(GL_TEXTURE_2D)), matt_(environment.matt) {
    const std::uint32_t id = id_.get();
    glTextureStorage2D(id, Environment::kLevels, GL_RGBA8, Environment::kSide, Environment::kSide);
    for (int level = 0; level < Environment::kLevels; ++level) {
        const int side = Environment::kSide >> level;
        glTextureSubImage2D(id, level, 0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE,
                            environment.levels[level].data());
    }
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void EnvironmentTexture::bind(std::uint32_t unit) const {
    glBindTextureUnit(unit, id_.get());
}

const EnvironmentTexture& Studios::of(bool bright) {
    std::optional<EnvironmentTexture>& texture = textures_[bright ? 1 : 0];
    if (!texture) {
        texture.emplace(environmentOf(bright));
    }
    return *texture;
}

}  // namespace kerf::render
