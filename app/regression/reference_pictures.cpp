#include "app/regression/reference_pictures.h"

#include <optional>

#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/regression/picture_check.h"

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
