#include "app/regression/picture_check.h"

#include <spdlog/fmt/fmt.h>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxPictureBytes = 512u << 20;

/// Nothing where the picture is as it should be.
std::optional<ReferenceDifference> differenceOf(const std::string& file,
                                                const std::filesystem::path& reference,
                                                const std::filesystem::path& run,
                                                OutputFolder& differences) {
    differences.remove(file);
    if (!std::filesystem::exists(run / file)) {
        return ReferenceDifference{file, true, "The picture " + file + " is missing."};
    }
    if (!std::filesystem::exists(reference / file)) {
        return ReferenceDifference{
            file, false,
            (reference / file).string() + ": there is no such picture; make it with --update."};
    }
    const PictureCheck check =
        checkPicture({file, {}, {}}, reference, run, differences, render::kStrictLimits);
    return check.alike ? std::nullopt
                       : std::optional(ReferenceDifference{file, false, sentenceAbout(check)});
}

}  // namespace

PictureCheck checkPicture(const ExpectedPicture& picture, const std::filesystem::path& expected,
                          const std::filesystem::path& run, OutputFolder& differences,
                          const render::PictureLimits& limits) {
    PictureCheck check;
    check.file = picture.file;
    std::error_code unknown;  // of a name that no file system takes there is no file
    check.missing = !std::filesystem::exists(run / picture.file, unknown);
    check.unknown = !std::filesystem::exists(expected / picture.file, unknown);
    if (check.missing || check.unknown) {
        return check;
    }
    if (!leadsInside(std::filesystem::canonical(expected), expected / picture.file)) {
        throw InputError((expected / picture.file).string() +
                         ": it leads out of the folder of expectations; put the picture itself "
                         "there.");
    }
    const render::Image before = readPicture(expected / picture.file);
    const render::Image now = readPicture(run / picture.file);
    check.comparison = render::comparePictures(before, now, picture.options);
    check.sizes = fmt::format("{}x{} pixels instead of {}x{}", now.width, now.height, before.width,
                              before.height);
    check.alike =
        check.comparison.pixelsCompared > 0 && render::withinLimits(check.comparison, limits);
    if (!check.alike && check.comparison.sameSize) {
        check.difference = differences.pathOf(picture.file);
        writePicture(render::differencePicture(before, check.comparison, picture.options),
                     check.difference);
    }
    check.comparison.errors.clear();
    return check;
}

std::string sentenceAbout(const PictureCheck& check) {
    const render::PictureComparison& found = check.comparison;
    if (check.missing) {
        return "The run made no picture " + check.file + " any more.";
    }
    if (check.unknown) {
        return "The picture " + check.file + " has no expectation; kerf test --update makes it.";
    }
    if (!found.sameSize) {
        return "The picture " + check.file + " has " + check.sizes + ".";
    }
    if (found.pixelsCompared == 0) {
        return "The masks leave nothing of the picture " + check.file + " to compare.";
    }
    const render::PixelRect& place = found.worstPlace;
    return fmt::format(
        "The picture {} differs in {:.2f} % of its pixels, by {:.2f} around ({}, {}).", check.file,
        100 * found.shareDiffering(), found.worst, place.x + place.width / 2,
        place.y + place.height / 2);
}

std::vector<ReferenceDifference> compareWithReference(const std::vector<std::string>& files,
                                                      const std::filesystem::path& reference,
                                                      const std::filesystem::path& run) {
    OutputFolder differences(OutputFolder(run).pathOf("diff"));
    std::vector<ReferenceDifference> found;
    for (const std::string& file : files) {
        if (auto difference = differenceOf(file, reference, run, differences)) {
            found.push_back(std::move(*difference));
        }
    }
    return found;
}

std::vector<std::string> renewReference(const std::vector<ReferenceDifference>& differences,
                                        const std::filesystem::path& reference,
                                        const std::filesystem::path& run) {
    OutputFolder folder(reference);
    for (const ReferenceDifference& difference : differences) {
        if (!difference.missingInRun) {
            folder.write(difference.file, readInputFile(run / difference.file, kMaxPictureBytes));
        }
    }
    return folder.written();
}

}  // namespace kerf::app
