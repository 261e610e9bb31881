#include "app/files/export/export.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "app/import/model_answer.h"
#include "app/import/scene_reader.h"
#include "sim/base/text.h"
#include "tests/paths.h"
#include "tests/support/fuzz/counted_file.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

namespace fs = std::filesystem;

// Mending takes its time, which is bounded by the limits of what is asked about: see docs/cli.md.
constexpr std::size_t kMostMended = 500;  // triangles

bool inThisProcess = false;

const TemporaryFolder& folder() {
    static const TemporaryFolder folder;
    return folder;
}

/// Images have the names of a file of others; nothing may be written beside the export.
std::string brokenByExport(const app::ModelMesh& model, app::MeshFormat format) {
    const fs::path target =
        folder() / ("out" + std::string(format == app::MeshFormat::obj ? ".obj" : ".gltf"));
    for (const app::ExportedFile& file :
         app::encodeExport({target}, model.mesh, findPieces(model.mesh), {model.looks, {}}, {})) {
        const std::string name = file.file.filename().string();
        if (file.file.parent_path() != target.parent_path() || name.starts_with(".") ||
            name.size() > 255) {
            return "It would be written as " + file.file.string();
        }
    }
    return "";
}

std::string brokenSurface(const app::ModelMesh& model) {
    std::string broken = checkClosedManifold(model.mesh);
    for (const app::MeshFormat format : {app::MeshFormat::obj, app::MeshFormat::gltf}) {
        broken += broken.empty() ? brokenByExport(model, format) : "";
    }
    return broken;
}

/// What becomes of an answer.
FuzzOutcome judge(const app::ImportAnswer& answer) {
    if (answer.outcome != app::ImportOutcome::cuttable) {
        return refusedWithClause(answer.reason);
    }
    return {true, brokenSurface(app::cuttableModel("a.obj", answer))};
}

/// What becomes of a model that was read.
FuzzOutcome buildSurface(const app::ImportedModel& model) {
    app::ImportOrder order;
    const bool small = model.soup.triangles.size() <= kMostMended;
    order.findCrossingsUpTo = kMostMended;
    order.tryRepair = small;
    const app::ImportAnswer asItIs = app::answerFor("a.obj", model, order);
    FuzzOutcome outcome = judge(asItIs);
    if (!outcome.broken.empty() || asItIs.outcome != app::ImportOutcome::faulty) {
        return outcome;
    }
    order.repair = small;
    order.fillHoles = small;
    if (small && model.soup.triangles.size() % 2 == 1) {
        order.thicken = 0;  // as proposed
    }
    return judge(app::answerFor("a.obj", model, order));
}

std::string brokenByEncoding(const app::ImportAnswer& answer) {
    const std::string bytes = app::encodeAnswer(answer);
    return app::encodeAnswer(app::decodeAnswers(bytes).front()) == bytes
               ? ""
               : "It comes back as another one.";
}

constexpr std::array<std::string_view, 13> kEndings{".obj", ".ply", ".stl", ".gltf", ".glb",
                                                    ".off", ".3ds", ".dae", ".fbx",  ".vtk",
                                                    ".vtp", ".vtu", ".msh"};

app::ImportAnswer answerOf(const fs::path& file) {
    return inThisProcess ? app::answersTo(file, {app::ImportOrder{}}).front()
                         : app::importModel(file);
}

/// As the file has it: before corners in one place become one.
app::ImportedModel arrivedFrom(const fs::path& file) {
    return app::readModelFile(file);
}

bool haveSameBounds(const TriangleSoup& soup, const Bounds& right) {
    Bounds bounds;
    for (const Triangle& triangle : soup.triangles) {
        for (const int vertex : triangle) {
            bounds.add(soup.positions[vertex]);
        }
    }
    const double reach =
        std::max(right.low.cwiseAbs().maxCoeff(), right.high.cwiseAbs().maxCoeff());
    const double step = 1e-6 * reach;  // of the float that a number may become
    return (bounds.low - right.low).cwiseAbs().maxCoeff() <= step &&
           (bounds.high - right.high).cwiseAbs().maxCoeff() <= step;
}

/// Whether a remark says that a part of the shape is not as in the file.
bool tellsOfShape(const std::vector<std::string>& remarks) {
    return std::ranges::any_of(remarks, [](const std::string& remark) {
        return !remark.starts_with("The material") && !remark.starts_with("The image") &&
               !remark.starts_with("A material");
    });
}

/// What arrived otherwise than the file says it, without a remark.
std::string brokenInSilence(const app::ImportedModel& arrived, const FileCount& said) {
    if (tellsOfShape(arrived.remarks)) {
        return "";
    }
    if (!said.damage.empty()) {
        return "It was read in silence, and is damaged: " + printable(said.damage);
    }
    const std::size_t triangles = arrived.soup.triangles.size();
    if (triangles < said.least || triangles > said.triangles) {
        return "It says " + std::to_string(said.triangles) + " triangles, and there arrived " +
               std::to_string(triangles) + " in silence.";
    }
    return said.bounds && !haveSameBounds(arrived.soup, *said.bounds)
               ? "Its corners arrived elsewhere in silence."
               : "";
}

/// A textured box of two materials.
app::ImportedModel paintedBox() {
    app::ImportedModel model{boxSoup(), {}, {}, {"A remark."}};
    model.soup.skin.uvs.resize(12, {Eigen::Vector2f(0, 0), {1, 0}, {0.5F, 1}});
    model.soup.skin.colors.resize(12, {Eigen::Vector4f(1, 1, 1, 1), {1, 0, 0, 1}, {0, 0, 1, 1}});
    for (int t = 0; t < 12; ++t) {
        model.soup.skin.materials.push_back(t % 3 - 1);
    }
    render::SurfaceMaterial glossy{"glossy", {0.5F, 0.25F, 1, 1}, 0.2F, 0.5F, 0};
    model.appearance.materials = {glossy, render::SurfaceMaterial{"plain"}};
    model.appearance.images = {{"sub/leaf.png", imageTexts().front(), {}}};
    return model;
}

}  // namespace

FuzzOutcome readAnswerBytes(const std::string& bytes) {
    try {
        const app::ImportAnswer answer = app::decodeAnswers(bytes).front();
        return {true, brokenByEncoding(answer)};
    } catch (const app::InputError& error) {
        return refusedWithClause(error.what());
    }
}

std::vector<std::string> answerTexts() {
    TriangleSoup open = icosphereSoup(0);
    open.triangles.pop_back();
    TriangleSoup turned = test::turned(boxSoup());
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    app::ImportOrder order;
    order.findFaults = order.tryRepair = true;
    std::vector<std::string> texts{app::encodeAnswer({.reason = "it is broken"})};
    for (const app::ImportedModel& model : {paintedBox(), app::ImportedModel{boxSoup()},
                                            app::ImportedModel{open}, app::ImportedModel{turned}}) {
        texts.push_back(app::encodeAnswer(app::answerFor("a.obj", model, order)));
    }
    return texts;
}

std::vector<std::string> answerWords() {
    std::vector<std::string> words{std::string(8, '\0'),
                                   std::string("\1\0\0\0\0\0\0\0", 8),
                                   std::string("\xff\xff\xff\x7f"),
                                   std::string(8, '\xff'),
                                   std::string("\0\0\xc0\x7f", 4),
                                   std::string("\0\0\0\0\0\0\xf0\x7f", 8)};
    for (const std::string& word : jsonWordsOf({R"({"materials": [], "images": [], "remarks": [],
             "name": "", "color": 1, "roughness": 1, "metallic": 0, "image": -1, "bytes": 0})"})) {
        words.push_back(word);
    }
    return words;
}

void readModelsInThisProcess() {
    inThisProcess = true;
}

FuzzOutcome readModelBytes(const std::string& bytes) {
    if (bytes.empty()) {
        return {};
    }
    const std::size_t kind = static_cast<unsigned char>(bytes[0]) % kEndings.size();
    const fs::path file = folder() / ("model" + std::string(kEndings[kind]));
    const std::string_view content = std::string_view(bytes).substr(1);
    writeText(file, content);
    app::ImportAnswer answer;
    try {
        answer = answerOf(file);
    } catch (const app::InputError& error) {
        return refusedWithClause(error.what());
    }
    if (answer.outcome == app::ImportOutcome::refused) {
        return refusedWithClause(answer.reason);
    }
    const std::optional<FileCount> said = countOf(kEndings[kind], content);
    const std::string broken = said ? brokenInSilence(arrivedFrom(file), *said) : "";
    FuzzOutcome outcome = broken.empty() ? buildSurface(answer.model) : FuzzOutcome{true, broken};
    outcome.read = true;
    outcome.judged = said.has_value();
    return outcome;
}

std::span<const std::string_view> modelEndings() {
    return kEndings;
}

std::vector<std::string> modelTexts() {
    const SurfaceMesh mesh = box();
    const PieceMap pieces = findPieces(mesh);
    std::vector<std::string> texts;
    for (std::size_t kind = 0; kind < kEndings.size(); ++kind) {
        const std::string ending(kEndings[kind]);
        const auto format = app::meshFormatOf("box" + ending);
        const fs::path kept = KERF_SOURCE_DIR "/tests/fuzz/models/box" + ending;
        texts.push_back(static_cast<char>(kind) +
                        (format ? app::encodeMesh(mesh, pieces, *format) : readBytes(kept)));
    }
    texts.push_back(std::string("\0", 1) + "mtllib ../a.mtl\nusemtl m\n" + objText(boxSoup()));
    texts.push_back(std::string("\1", 1) +
                    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                    "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nelement face 4\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n0 0 1 9 9 9\n"
                    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    return texts;
}

std::vector<std::string> modelWords() {
    std::vector<std::string> words = answerWords();
    for (const std::string& word :
         wordsOf({modelTexts()[0], modelTexts()[1], modelTexts()[3], modelTexts()[7],
                  modelTexts()[9], modelTexts()[10], modelTexts()[12], modelTexts()[13]})) {
        if (word.size() < 40) {
            words.push_back(word);
        }
    }
    for (const char* word : {"../", "/dev/zero", "nan", "1e38", "-1", "99999999", "map_Kd ",
                             "\"uri\":\"../a.png\"", "data:application/octet-stream;base64,"}) {
        words.emplace_back(word);
    }
    return words;
}

}  // namespace kerf::test
