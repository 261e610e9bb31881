#include "app/cli/compare_verb.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using render::ChannelDifference;
using render::Image;
using render::PictureComparison;
using render::PictureLimits;
using render::PixelRect;

/// Two pictures of which each figure is known.
struct Findings {
    PictureComparison seen;
    ChannelDifference channels;
    bool equal = false;
};

const PictureLimits& limitsOf(const CompareArguments& arguments) {
    return arguments.tolerant ? render::kTolerantLimits : render::kStrictLimits;
}

bool areEqual(const Findings& findings, const CompareArguments& arguments) {
    return arguments.threshold
               ? findings.seen.sameSize && findings.channels.mean <= *arguments.threshold
               : withinLimits(findings.seen, limitsOf(arguments));
}

Findings compare(const Image& a, const Image& b, const CompareArguments& arguments) {
    Findings findings;
    findings.seen = comparePictures(a, b, {arguments.masks});
    findings.channels = channelDifference(a, b, {arguments.masks});
    findings.equal = areEqual(findings, arguments);
    return findings;
}

/// A mask that lies outside of both pictures was meant otherwise.
void checkMasks(const Image& a, const Image& b, const std::vector<PixelRect>& masks) {
    for (const PixelRect& mask : masks) {
        if (mask.x >= std::max(a.width, b.width) || mask.y >= std::max(a.height, b.height)) {
            throw InputError(
                fmt::format("--mask {},{},{},{}: this lies outside of the picture, "
                            "which is {}x{}.",
                            mask.x, mask.y, mask.width, mask.height, a.width, a.height));
        }
    }
}

/// The picture of the difference must not take the place of what was compared.
void checkTarget(const CompareArguments& arguments) {
    for (const std::filesystem::path& picture : {arguments.a, arguments.b}) {
        std::error_code error;
        if (std::filesystem::equivalent(arguments.diff, picture, error)) {
            throw UsageError("--diff " + arguments.diff.string() +
                             ": this is one of the two pictures; choose another name");
        }
    }
}

void checkRest(const PictureComparison& comparison) {
    if (comparison.pixelsCompared == 0) {
        throw InputError("The masks leave nothing of the pictures to compare.");
    }
}

nlohmann::ordered_json toJson(const PixelRect& rect) {
    return {rect.x, rect.y, rect.width, rect.height};
}

nlohmann::ordered_json limitsAsJson(const CompareArguments& arguments) {
    if (arguments.threshold) {
        return nullptr;
    }
    return {{"pixels", limitsOf(arguments).pixels}, {"worst", limitsOf(arguments).worst}};
}

void printJson(const Findings& findings, const CompareArguments& arguments, bool wroteDiff,
               std::ostream& out) {
    const PictureComparison& seen = findings.seen;
    nlohmann::ordered_json report = {{"equal", findings.equal},
                                     {"identical", seen.identical},
                                     {"same_size", seen.sameSize},
                                     {"pixels_differing", seen.pixelsDiffering},
                                     {"pixels_compared", seen.pixelsCompared},
                                     {"worst", seen.worst},
                                     {"worst_at", nullptr},
                                     {"mean", seen.mean},
                                     {"limits", limitsAsJson(arguments)},
                                     {"mean_error", findings.channels.mean},
                                     {"max_error", findings.channels.largest},
                                     {"differing_pixels", findings.channels.pixels},
                                     {"threshold", nullptr},
                                     {"diff", nullptr}};
    if (seen.worstPlace.width > 0) report["worst_at"] = toJson(seen.worstPlace);
    if (arguments.threshold) report["threshold"] = *arguments.threshold;
    if (wroteDiff) report["diff"] = arguments.diff.string();
    out << report.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

/// " around x 31, y 20", or nothing where all is as it was.
std::string describePlace(const PixelRect& place) {
    return place.width == 0 ? ""
                            : fmt::format(" around x {}, y {}", place.x + place.width / 2,
                                          place.y + place.height / 2);
}

/// What was found, beside the limits: "12 of 3600 pixels differ visibly (0.333 %, limit 0.1 %), the
/// worst place by 0.51 (limit 0.13) around x 31, y 20, mean 0.0021". `comparison` is of pictures of
/// one size.
std::string describeComparison(const PictureComparison& comparison, const PictureLimits& limits) {
    return fmt::format(
        "{} of {} pixels differ visibly ({:.3g} %, limit {:.3g} %), the worst place by {:.3g} "
        "(limit {:.3g}){}, mean {:.3g}",
        comparison.pixelsDiffering, comparison.pixelsCompared, 100 * comparison.shareDiffering(),
        100 * limits.pixels, comparison.worst, limits.worst, describePlace(comparison.worstPlace),
        comparison.mean);
}

std::string describeChannels(const Findings& findings, double threshold) {
    return fmt::format(
        "mean difference of a channel {:.3g} (threshold {:.3g}), the largest {:.3g}, {} by more "
        "than 2/255, worst place{}",
        findings.channels.mean, threshold, findings.channels.largest,
        counted(findings.channels.pixels, "pixel", "pixels"),
        describePlace(findings.seen.worstPlace));
}

/// What the figures come to, in a word or two.
std::string verdict(const Findings& findings, const CompareArguments& arguments) {
    if (!findings.equal) {
        return "differ";
    }
    return arguments.threshold ? "equal within the threshold" : "equal within the limits";
}

void printLine(const Findings& findings, const CompareArguments& arguments, std::ostream& out) {
    if (findings.seen.identical) {
        out << (arguments.masks.empty() ? "equal\n" : "equal outside the masks\n");
        return;
    }
    out << verdict(findings, arguments) << ": "
        << (arguments.threshold ? describeChannels(findings, *arguments.threshold)
                                : describeComparison(findings.seen, limitsOf(arguments)))
        << '\n';
}

void printSizes(const Image& a, const Image& b, bool wantsDiff, std::ostream& out) {
    out << "differ in size: " << a.width << "x" << a.height << " and " << b.width << "x" << b.height
        << (wantsDiff ? "; no picture of the difference is written" : "") << '\n';
}

/// CLI::Range lets NaN pass.
std::string refuseOutsideOfOne(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    const bool valid = value && *value >= 0 && *value <= 1;
    return valid ? "" : "'" + text + "' is no number from 0 to 1";
}

std::string refuseNoMask(const std::string& text) {
    return readMask(text) ? "" : "'" + text + "' is no rectangle X,Y,W,H in whole pixels";
}

/// "at most 0.1 % of the pixels may differ visibly, and the worst place by 0.13".
std::string describeLimits(const PictureLimits& limits) {
    return fmt::format(
        "at most {:.3g} % of the pixels may differ visibly, and the worst place by {}",
        100 * limits.pixels, limits.worst);
}

/// What decides where no threshold is named.
std::string explainLimits() {
    return "Without --threshold " + describeLimits(render::kStrictLimits) + ";\nwith --tolerant " +
           describeLimits(render::kTolerantLimits) + ".\nVisibly means by more than " +
           formatNumber(render::kVisibleError) + " of LDR-FLIP; a place is " +
           std::to_string(render::kPlaceSide) + " pixels wide.";
}

void describeHowToCompare(CLI::App& verb, CompareArguments& arguments) {
    CLI::Option* threshold =
        verb.add_option("--threshold", arguments.threshold,
                        "Largest mean channel difference that passes, instead of the limits below")
            ->check(refuseOutsideOfOne)
            ->type_name("T");
    verb.add_flag("--tolerant", arguments.tolerant, "Wide limits, for pictures of another driver")
        ->excludes(threshold);
    verb.add_option_function<std::vector<std::string>>(
            "--mask",
            [&arguments](const std::vector<std::string>& masks) {
                for (const std::string& mask : masks) {
                    arguments.masks.push_back(*readMask(mask));
                }
            },
            "A rectangle of pixels to ignore; may be given several times")
        ->check(refuseNoMask)
        ->allow_extra_args(false)
        ->type_name("X,Y,W,H");
}

std::function<int()> describeCompare(CLI::App& verb) {
    const auto arguments = std::make_shared<CompareArguments>();
    verb.add_option("A", arguments->a, "A PNG file")->required();
    verb.add_option("B", arguments->b, "The other picture")->required();
    describeHowToCompare(verb, *arguments);
    verb.add_option("--diff", arguments->diff,
                    "Picture of the difference, written only if they differ")
        ->type_name("D.png");
    verb.add_flag("--json", arguments->json, "Print one JSON object");
    verb.footer(explainLimits());
    return [arguments] { return runCompare(*arguments, std::cout); };
}

}  // namespace

const Verb kCompareVerb{"compare", "Compare two PNG pictures", describeCompare};

std::optional<PixelRect> readMask(const std::string& text) {
    std::array<int, 4> numbers{};
    const char* next = text.data();
    const char* end = next + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool parted = i == 0 || (next != end && *next++ == ',');
        const auto read = std::from_chars(next, end, numbers[i]);
        if (!parted || read.ec != std::errc() || numbers[i] < (i < 2 ? 0 : 1)) {
            return std::nullopt;
        }
        next = read.ptr;
    }
    return next == end ? std::optional(PixelRect{numbers[0], numbers[1], numbers[2], numbers[3]})
                       : std::nullopt;
}

int runCompare(const CompareArguments& arguments, std::ostream& out) {
    checkTarget(arguments);
    const Image a = readPicture(arguments.a);
    const Image b = readPicture(arguments.b);
    checkMasks(a, b, arguments.masks);
    const Findings findings = compare(a, b, arguments);
    checkRest(findings.seen);
    const bool writesDiff = !findings.equal && !arguments.diff.empty() && findings.seen.sameSize;
    if (writesDiff) {
        writePicture(differencePicture(a, findings.seen, {arguments.masks}), arguments.diff);
    }
    if (arguments.json) {
        printJson(findings, arguments, writesDiff, out);
    } else if (!findings.seen.sameSize) {
        printSizes(a, b, !arguments.diff.empty(), out);
    } else {
        printLine(findings, arguments, out);
    }
    return findings.equal ? kExitDone : kExitCheckFailed;
}

}  // namespace kerf::app
