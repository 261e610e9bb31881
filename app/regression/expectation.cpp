#include "app/regression/expectation.h"

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using InputJson = nlohmann::json;
using Json = nlohmann::ordered_json;
using render::PixelRect;

constexpr std::uintmax_t kMaxExpectationBytes = 1u << 20;
constexpr const char* kFormat = "kerf-expected";

[[noreturn]] void fail(const std::string& key, const std::string& problem) {
    throw InputError(key + ": " + problem);
}

/// A key that nobody reads would hold nothing, and nobody would know.
void refuseUnknownKeys(const InputJson& object, const std::string& place,
                       std::initializer_list<std::string_view> known) {
    for (const auto& item : object.items()) {
        if (std::ranges::find(known, item.key()) == known.end()) {
            fail(place + shortened(item.key()),
                 "there is no such key; known are " +
                     joined(std::vector<std::string>(known.begin(), known.end()), ", ") + ".");
        }
    }
}

/// The value of a key, which must be there.
const InputJson& at(const InputJson& object, const std::string& key) {
    if (!object.is_object() || !object.contains(key)) {
        fail(key, "this key is missing; renew the file with kerf test --update.");
    }
    return object[key];
}

std::string textAt(const InputJson& object, const std::string& key) {
    const InputJson& value = at(object, key);
    if (!value.is_string()) {
        fail(key, "expected a text in quotes.");
    }
    return value.get<std::string>();
}

double numberIn(const InputJson& value, const std::string& key, double low, double high) {
    if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
        fail(key,
             "expected a number from " + formatNumber(low) + " to " + formatNumber(high) + ".");
    }
    return value.get<double>();
}

/// A number from 0 to 1; `otherwise` where the key is missing.
double shareAt(const InputJson& object, const std::string& key, double otherwise) {
    return object.contains(key) ? numberIn(object[key], key, 0, 1) : otherwise;
}

/// An object under a key, which may be missing.
InputJson objectAt(const InputJson& object, const std::string& key) {
    InputJson value = object.value(key, InputJson::object());
    if (!value.is_object()) {
        fail(key, "expected an object in braces.");
    }
    return value;
}

PixelRect readMask(const InputJson& value, const std::string& place) {
    constexpr double kMostPixels = 32768;
    if (!value.is_array() || value.size() != 4) {
        fail(place, "expected four numbers for each: x, y, width, height [pixels].");
    }
    int numbers[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const double number = numberIn(value[i], place, i < 2 ? 0 : 1, kMostPixels);
        numbers[i] = static_cast<int>(number);
        if (numbers[i] != number) {
            fail(place, "expected whole pixels.");
        }
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

/// The file may be removed when the expectation is renewed, so it must lie in the folder.
void requireInside(const std::string& file) {
    if (!isNameInside(file)) {
        fail("pictures", "'" + shortened(file) + "' is no file inside the folder.");
    }
}

/// How far pictures may be apart, under a key at a place; `otherwise` for what is missing.
render::PictureLimits limitsIn(const InputJson& object, const std::string& key,
                               const std::string& place, const render::PictureLimits& otherwise) {
    const InputJson limits = objectAt(object, key);
    refuseUnknownKeys(limits, place + key + ", ", {"pixels", "worst"});
    return {shareAt(limits, "pixels", otherwise.pixels), shareAt(limits, "worst", otherwise.worst)};
}

ExpectedPicture readExpectedPicture(const std::string& file, const InputJson& value) {
    ExpectedPicture picture{file, {}, {}};
    requireInside(file);
    if (!value.is_object()) {
        fail("pictures", "expected an object in braces for " + shortened(file) + ".");
    }
    refuseUnknownKeys(value, "pictures, " + shortened(file) + ", ", {"masks", "limits"});
    for (const InputJson& mask : value.value("masks", InputJson::array())) {
        picture.options.masks.push_back(readMask(mask, "pictures, " + shortened(file) + ", masks"));
    }
    if (value.contains("limits")) {
        picture.limits =
            limitsIn(value, "limits", "pictures, " + shortened(file) + ", ", render::kStrictLimits);
    }
    return picture;
}

Tolerances readTolerances(const InputJson& top) {
    Tolerances tolerances;
    const InputJson given = objectAt(top, "tolerances");
    refuseUnknownKeys(given, "tolerances, ", {"positions", "volume", "pictures"});
    tolerances.positions = shareAt(given, "positions", tolerances.positions);
    tolerances.volume = shareAt(given, "volume", tolerances.volume);
    tolerances.pictures = limitsIn(given, "pictures", "tolerances, ", tolerances.pictures);
    return tolerances;
}

Expectation parseExpectation(const InputJson& top) {
    if (textAt(top, "format") != kFormat) {
        fail("format", std::string("expected \"") + kFormat + "\"; this is some other file.");
    }
    if (at(top, "version") != 1) {
        fail("version", "expected 1, the only one that this Kerf knows.");
    }
    refuseUnknownKeys(
        top, "",
        {"format", "version", "made_with", "steps", "state_hash", "tolerances", "pictures"});
    Expectation expectation;
    const InputJson& made = at(top, "made_with");
    expectation.kerf = textAt(made, "kerf");
    expectation.driver = {textAt(made, "renderer"), textAt(made, "driver")};
    expectation.steps = static_cast<int>(numberIn(at(top, "steps"), "steps", 0, 1e9));
    expectation.stateHash = textAt(top, "state_hash");
    expectation.tolerances = readTolerances(top);
    const InputJson pictures = objectAt(top, "pictures");
    for (const auto& item : pictures.items()) {
        expectation.pictures.push_back(readExpectedPicture(item.key(), item.value()));
    }
    return expectation;
}

Json toJson(const render::PictureLimits& limits) {
    return {{"pixels", limits.pixels}, {"worst", limits.worst}};
}

Json toJson(const ExpectedPicture& picture) {
    Json json = Json::object();
    for (const PixelRect& mask : picture.options.masks) {
        json["masks"].push_back({mask.x, mask.y, mask.width, mask.height});
    }
    if (picture.limits) {
        json["limits"] = toJson(*picture.limits);
    }
    return json;
}

}  // namespace

std::filesystem::path expectationFolder(const std::filesystem::path& session) {
    std::string name = session.filename().string();
    if (name.ends_with(kSessionEnding)) {
        name.resize(name.size() - kSessionEnding.size());
    }
    return session.parent_path() / (name + ".expected");
}

std::vector<std::string> unlistedPictures(const std::filesystem::path& folder,
                                          const Expectation& expectation) {
    const auto isListed = [&](const std::filesystem::path& file) {
        return std::ranges::any_of(expectation.pictures, [&](const ExpectedPicture& picture) {
            return std::filesystem::path(picture.file).lexically_normal() == file;
        });
    };
    std::vector<std::string> unlisted;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::filesystem::path file = entry.path().lexically_relative(folder);
        if (lowerCase(file.extension().string()) == ".png" && !isListed(file)) {
            unlisted.push_back(file.generic_string());
        }
    }
    return unlisted;
}

Expectation readExpectation(const std::filesystem::path& file) {
    const std::string text = readInputFile(file, kMaxExpectationBytes);
    try {
        return parseExpectation(parseJson(text));
    } catch (const InputError& error) {
        throw InputError(file.string() + ": " + error.what() +
                         " Mend it, or remove it and run kerf test --update.");
    }
}

std::string formatExpectation(const Expectation& expectation) {
    Json json;
    json["format"] = kFormat;
    json["version"] = 1;
    json["made_with"] = {{"kerf", expectation.kerf},
                         {"renderer", expectation.driver.renderer},
                         {"driver", expectation.driver.version}};
    json["steps"] = expectation.steps;
    json["state_hash"] = expectation.stateHash;
    json["tolerances"] = {{"positions", expectation.tolerances.positions},
                          {"volume", expectation.tolerances.volume},
                          {"pictures", toJson(expectation.tolerances.pictures)}};
    json["pictures"] = Json::object();
    for (const ExpectedPicture& picture : expectation.pictures) {
        json["pictures"][picture.file] = toJson(picture);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::app
