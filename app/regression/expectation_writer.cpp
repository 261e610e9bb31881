#include "app/regression/expectation_writer.h"

#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxKeptBytes = 1u << 30;

std::optional<Expectation> earlierExpectation(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kExpectedFile;
    return std::filesystem::exists(file) ? std::optional(readExpectation(file)) : std::nullopt;
}

const ExpectedPicture* findPicture(const Expectation& expectation, const std::string& file) {
    const auto found = std::ranges::find(expectation.pictures, file, &ExpectedPicture::file);
    return found == expectation.pictures.end() ? nullptr : &*found;
}

/// With what a person set in the earlier one.
Expectation expectationOf(const RunResults& results, const Expectation& earlier) {
    Expectation expectation{
        KERF_VERSION,      results.driver,     static_cast<int>(results.trace.size()),
        results.stateHash, earlier.tolerances, {}};
    for (const TakenPicture& picture : results.pictures) {
        const ExpectedPicture* before = findPicture(earlier, picture.file);
        expectation.pictures.push_back(before != nullptr ? *before
                                                         : ExpectedPicture{picture.file, {}, {}});
    }
    return expectation;
}

void copyFile(const RunResults& results, const std::string& name, OutputFolder& folder) {
    folder.write(name, readInputFile(results.folder / name, kMaxKeptBytes));
}

}  // namespace

void writeExpectation(const std::filesystem::path& expectationFolder, const RunResults& results) {
    if (std::filesystem::is_symlink(expectationFolder)) {
        throw OutputError(expectationFolder.string() +
                          ": this is a link, through which nothing is written; put the folder "
                          "itself there.");
    }
    const Expectation earlier = earlierExpectation(expectationFolder).value_or(Expectation{});
    const Expectation expectation = expectationOf(results, earlier);
    OutputFolder folder(expectationFolder);
    for (const std::string& file : unlistedPictures(expectationFolder, expectation)) {
        folder.remove(file);
    }
    for (const ExpectedPicture& picture : expectation.pictures) {
        copyFile(results, picture.file, folder);
    }
    copyFile(results, kHashesFile, folder);
    folder.write(kTraceFile, formatTrace(results.trace));
    folder.write(kPieceBoxesFile, formatPieces(thinnedOut(results.pieces)));
    folder.write(kExpectedFile, formatExpectation(expectation));
}

}  // namespace kerf::app
