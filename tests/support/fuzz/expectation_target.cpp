#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/regression/judgement.h"
#include "app/regression/test_session.h"
#include "tests/support/fuzz/packed_files.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

namespace fs = std::filesystem;

const std::string kCourse =
    "step,volume,pieces,vertices,triangles\n0,0.5,1,12,20\n1,0.5,1,12,20\n2,0.498,2,18,32\n";
const std::string kPieces =
    "step,piece,volume,low_x,low_y,low_z,high_x,high_y,high_z\n0,0,0.5,-0.5,-0.5,-0.5,0.5,0.5,0.5\n"
    "2,0,0.25,-0.5,-0.5,-0.5,0,0.5,0.5\n2,1,0.248,0,-0.5,-0.5,0.5,0.5,0.5\n";
const std::string kHashes =
    "step,state_hash,topology_hash,positions_hash,velocities_hash,boxes_hash,parameters_hash,"
    "blade_hash\n"
    "0,125c465eccedf747,20d375fe04bf090b,cb6151a8fb141799,e066e42f2a43e92d,cbf29ce484222325,"
    "2982101d26468825,cbf29ce484222325\n"
    "1,94d92d2b711e814d,20d375fe04bf090b,22626d420890d71c,7e1bf9b55dc3592e,cbf29ce484222325,"
    "2982101d26468825,cbf29ce484222325\n"
    "2,0123456789abcdef,11d375fe04bf090b,32626d420890d71c,8e1bf9b55dc3592e,cbf29ce484222325,"
    "2982101d26468825,cbf29ce484222325\n";

render::Image grey(int brightness) {
    render::Image image{8, 8, std::vector<std::uint8_t>(8 * 8 * 4, std::uint8_t(brightness))};
    return image;
}

/// A folder with the results of a run in `run`, expectations in `x.expected`, and a picture beside
/// both that is nobody's business.
class Place {
  public:
    Place() {
        for (const fs::path& made : {run(), expected()}) {
            fs::create_directories(made);
            app::writePicture(grey(90), made / "a.png");
            app::writePicture(grey(120), made / "b.png");
        }
        app::writePicture(grey(200), run() / "b.png");
        app::writePicture(grey(7), folder_ / "c.png");
        writeText(run() / app::kHashesFile, kHashes);
        results.folder = run();
        results.driver = {"llvmpipe", "4.5"};
        results.stateHash = "0123456789abcdef";
        results.pictures = {{"a.png", 1}, {"b.png", 2}};
        results.hashes = app::HashTrace::read(run() / app::kHashesFile);
        writeText(folder_ / "course.csv", kCourse);
        writeText(folder_ / "pieces.csv", kPieces);
        results.trace = app::readTrace(folder_ / "course.csv");
        results.pieces = app::readPieces(folder_ / "pieces.csv");
        before_ = content();
    }

    fs::path run() const { return folder_ / "run"; }
    fs::path expected() const { return folder_ / "x.expected"; }
    fs::path differences() const { return folder_ / "diff"; }
    /// Whether all is as it was but for the expectations and the differences.
    bool untouched() const { return content() == before_; }

    app::RunResults results;

  private:
    std::set<std::string> content() const {
        std::set<std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
            const fs::path file = entry.path().lexically_relative(folder_.path());
            if (*file.begin() != "x.expected" && *file.begin() != "diff") {
                files.insert(file.string() + (entry.is_regular_file() ? readBytes(entry) : ""));
            }
        }
        return files;
    }

    TemporaryFolder folder_;
    std::set<std::string> before_;
};

Place& place() {
    static Place one;
    return one;
}

/// "" where what `write` makes of a value is read as one of which it makes the same.
template <class Value, class Read, class Write>
std::string brokenByWriting(const Value& value, const fs::path& file, Read read, Write write) {
    const std::string text = write(value);
    writeText(file, text);
    return write(read(file)) == text ? "" : "It reads back otherwise: " + text;
}

std::string brokenTables() {
    const fs::path folder = place().expected();
    const fs::path again = place().differences().parent_path() / "x.expected/again";
    std::string broken = brokenByWriting(app::readExpectation(folder / app::kExpectedFile), again,
                                         app::readExpectation, app::formatExpectation);
    broken += brokenByWriting(app::readTrace(folder / app::kTraceFile), again, app::readTrace,
                              app::formatTrace);
    broken += brokenByWriting(app::readPieces(folder / app::kPieceBoxesFile), again,
                              app::readPieces, app::formatPieces);
    fs::remove(again);
    return broken;
}

}  // namespace

FuzzOutcome readExpectationText(const std::string& text) {
    unpack(text, place().expected(),
           {app::kExpectedFile, app::kTraceFile, app::kPieceBoxesFile, app::kHashesFile});
    FuzzOutcome outcome;
    try {
        outcome.broken = brokenTables();
        app::judge(place().expected(), place().results, place().differences());
        app::writeExpectation(place().expected(), place().results);
        outcome.accepted = true;
    } catch (const app::InputError& error) {
        outcome = refusedWith(error.what());
    } catch (const app::OutputError& error) {
        outcome = refusedWith(error.what());
    }
    if (!place().untouched()) {
        outcome.broken = "Something outside of the folder has changed.";
    }
    return outcome;
}

std::vector<std::string> expectationTexts() {
    app::Expectation expectation{"0.1.0", {"llvmpipe", "4.5"}, 3, "0123456789abcdef", {}, {}};
    expectation.pictures = {{"a.png", {}, {}}, {"b.png", {}, {}}};
    const std::string plain = app::formatExpectation(expectation);
    expectation.driver.renderer = "another";
    expectation.pictures[1].options.masks = {{0, 0, 4, 4}, {2, 2, 6, 6}};
    expectation.pictures[1].limits = {0.01, 0.5};
    return {packed({plain, kCourse, kPieces, kHashes}),
            packed({app::formatExpectation(expectation), kCourse, kPieces, kHashes})};
}

std::vector<std::string> expectationWords() {
    std::vector<std::string> words = jsonWordsOf({expectationTexts().back()});
    for (const char* name : {"../c.png", "../run/a.png", "/c.png", "sub/../a.png", "a.png\\u0000",
                             "x.expected/../../c.png", "~/a.png", "/dev/full"}) {
        words.push_back("\"" + std::string(name) + "\": {}");
    }
    return words;
}

}  // namespace kerf::test
