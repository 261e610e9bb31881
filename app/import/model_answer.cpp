#include "app/import/model_answer.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "app/files/io/file_io.h"
#include "app/files/io/system_file.h"
#include "app/files/jobs/process_limits.h"
#include "app/import/mending.h"
#include "app/import/scene_reader.h"
#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

// --- What was read ---------------------------------------------------------------------------

/// One line of printable ASCII: what a reader quotes from a damaged file may be anything.
std::string cleaned(std::string_view message) {
    constexpr std::size_t kMost = 1000;
    std::string line(message.substr(0, std::min(message.find('\n'), kMost)));
    std::ranges::replace_if(
        line, [](char c) { return c < ' ' || c > '~'; }, '?');
    return line.empty() ? "no reason given" : line.substr(0, line.find_last_not_of(". ") + 1);
}

ImportedModel readOrSayWhyNot(const fs::path& file) {
    try {
        return readModelFile(file);
    } catch (const std::exception& error) {
        const std::string reason = cleaned(plainReason(error));
        // Sentences of ours say what to do, behind a semicolon.
        throw InputError(
            reason.find("; export it") != std::string::npos
                ? reason
                : "it can't be read (" + reason +
                      "); check that it is what its extension says, or export it again");
    }
}

void requireSize(const TriangleSoup& soup) {
    if (soup.positions.size() > kMaxImportVertices || soup.triangles.size() > kMaxImportTriangles) {
        throw InputError(fmt::format(
            "{} triangles and {} vertices, of which at most {} and {} are read; "
            "decimate the model",
            soup.triangles.size(), soup.positions.size(), kMaxImportTriangles, kMaxImportVertices));
    }
    if (soup.triangles.empty()) {
        throw InputError("there is no triangle in it; export the model as a triangle mesh");
    }
}

/// Of a model of which no more is known than how many triangles it has, cut as sparingly as can be.
void requireMemoryFor(const fs::path& file, const TriangleSoup& soup,
                      const std::optional<MemoryMeans>& means) {
    if (means) {
        const BodySize size = BodySize::ofTriangles(static_cast<double>(soup.triangles.size()));
        requireMemory(file.filename().string(), memoryNeedOf(size, {.contact = false}), *means);
    }
}

void requireRoom(const TriangleSoup& soup) {
    const auto bad =
        std::ranges::count_if(soup.positions, [](const Vec3& p) { return !p.allFinite(); });
    if (bad > 0) {
        throw InputError(
            counted(bad, "vertex has a coordinate that is", "vertices have coordinates that are") +
            " not a finite number; the file is damaged, export it again");
    }
    const Bounds bounds = boxOf(soup.positions);
    const double extent = (bounds.high - bounds.low).maxCoeff();
    const double farthest =
        std::max(bounds.high.cwiseAbs().maxCoeff(), bounds.low.cwiseAbs().maxCoeff());
    if (extent < kMinImportExtent || farthest > kMaxImportExtent) {
        throw InputError(
            fmt::format("the model is {:g} long and reaches {:g} from the origin, but must be "
                        "longer than {:g} and stay within {:g}; scale or move it",
                        extent, farthest, kMinImportExtent, kMaxImportExtent));
    }
}

// --- Its objects -----------------------------------------------------------------------------

/// Those that hang together have become one, by the number and name of the first of them.
void numberObjects(ImportedModel& model) {
    std::vector<int> numbers(model.facts.objects.size(), -1);
    std::vector<std::string> names;
    for (int& object : model.soup.objects) {
        int& number = numbers[object];
        if (number < 0) {
            number = static_cast<int>(names.size());
            names.push_back(model.facts.objects[object]);
        }
        object = number;
    }
    model.facts.objects = std::move(names);
}

/// Keeps the items of a list that numbers name, in the order in which they first do.
template <class Item>
struct UsedItems {
    const std::vector<Item>& all;
    std::vector<Item> used{};
    std::map<int, int> numbers{};

    /// The number becomes that in the list of used ones.
    void take(int& number) {
        if (number >= 0) {
            const auto [place, isNew] = numbers.try_emplace(number, static_cast<int>(used.size()));
            if (isNew) {
                used.push_back(all[number]);
            }
            number = place->second;
        }
    }
};

/// A scene may hold a model for each object of a file: none is to bring the images of all.
void dropUnusedLooks(ImportedModel& model) {
    UsedItems<render::SurfaceMaterial> materials{model.appearance.materials};
    UsedItems<render::ModelImage> images{model.appearance.images};
    std::ranges::for_each(model.soup.skin.materials, [&](int& number) { materials.take(number); });
    for (render::SurfaceMaterial& material : materials.used) {
        images.take(material.image);
    }
    model.appearance = {std::move(materials.used), std::move(images.used)};
}

/// Leaves out the others.
void takeObject(ImportedModel& model, int object) {
    TriangleSoup& soup = model.soup;
    if (object > 0) {
        const int count = std::max<int>(1, static_cast<int>(model.facts.objects.size()));
        if (object > count) {
            throw InputError("object " + std::to_string(object) + " is wanted, but it has " +
                             counted(count, "object", "objects") +
                             "; name another one in \"object\", or none");
        }
        if (!soup.objects.empty()) {
            repair::keepTriangles(soup, [&](int t) { return soup.objects[t] + 1 == object; });
            repair::dropUnusedVertices(soup);
            dropUnusedLooks(model);
        }
    }
    soup.objects.clear();
}

// --- Its looks -------------------------------------------------------------------------------

/// A picture that can't be shown is left out of the materials.
void decodeImages(ImportedModel& model) {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < model.appearance.images.size(); ++i) {
        render::ModelImage& image = model.appearance.images[i];
        try {
            const render::PixelRect size = render::sizeOfImage(image.bytes);
            pixels += std::size_t(size.width) * std::size_t(size.height);
            if (pixels > render::kMaxTexturePixels) {
                throw std::runtime_error("all images together have more pixels than are read");
            }
            image.pixels = render::decodeImage(image.bytes);
        } catch (const std::runtime_error& error) {
            model.remarks.push_back("The image \"" + image.name +
                                    "\" was left out: " + error.what() +
                                    "; save it anew as PNG and open the model again.");
            for (render::SurfaceMaterial& material : model.appearance.materials) {
                material.image = material.image == static_cast<int>(i) ? -1 : material.image;
            }
        }
    }
}

/// Those that are asked for; crossing triangles are counted in the report.
repair::Faults findFaults(const TriangleSoup& soup, MeshReport& found, const ImportOrder& order) {
    const bool crossings =
        soup.triangles.size() <= order.findCrossingsUpTo && found.outOfRangeIndices == 0;
    if (!order.findFaults) {
        if (crossings) {
            countCrossings(soup, found);
        }
        return {};
    }
    repair::Faults faults = repair::findFaults(soup, crossings);
    found.crossingTriangles = faults.of(repair::FaultKind::crossingTriangle).count();
    return faults;
}

/// What is left of crossing pieces, and what can be done about it.
void noteCrossings(const MeshReport& found, bool repaired, std::vector<std::string>& remarks) {
    for (const std::string& left : found.left) {
        remarks.push_back("Left as it is: " + left + ".");
    }
    if (found.crossingTriangles > 0 && !repaired) {
        remarks.push_back(counted(found.crossingTriangles, "triangle passes", "triangles pass") +
                          " through others: where they do, the material counts twice and faces of "
                          "cuts cross; a repair unites pieces that cross (Unite pieces, under "
                          "Model; kerf inspect --repair).");
    }
}

/// What is done once, whatever is ordered.
void weld(const fs::path& file, ImportedModel& model, const std::optional<MemoryMeans>& means) {
    requireSize(model.soup);
    requireMemoryFor(file, model.soup, means);
    tellStage("Joining equal vertices");
    model.soup = weldObjects(model.soup);
    numberObjects(model);
    requireRoom(model.soup);
}

/// The answer for a welded model as far as it goes before an exception.
void answer(const ImportOrder& order, ImportAnswer& answer) {
    ImportedModel& model = answer.model;
    takeObject(model, order.object);
    tellStage("Looking for faults");
    answer.report = mend(model.soup, order);
    answer.faults = findFaults(model.soup, answer.report, order);
    answer.outcome = answer.report.cuttable ? ImportOutcome::cuttable : ImportOutcome::faulty;
    answer.reason = answer.report.problem;
    if (order.tryRepair) {
        answer.help = helpFor(model.soup, answer.report);
    }
    decodeImages(model);
    if (answer.report.cuttable) {
        noteCrossings(answer.report, order.repair, model.remarks);
    }
}

/// Calls `work`; what it throws becomes the answer.
ImportAnswer guarded(const std::function<void(ImportAnswer& answer)>& work) {
    ImportAnswer answer;
    try {
        work(answer);
    } catch (const InputError& error) {
        answer = {.outcome = ImportOutcome::refused, .reason = error.what()};
    } catch (const MemoryShortage& error) {
        answer = {.outcome = ImportOutcome::outOfMemory, .reason = error.what()};
    } catch (const std::bad_alloc&) {
        answer = {.outcome = ImportOutcome::refused,
                  .reason = "it needs more memory than a model may; decimate it"};
    }
    return answer;
}

/// The answer's stream, set aside so that nothing that a library prints gets into it.
int takeStandardOutput() {
    const int answer = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    return answer;
}

}  // namespace

std::vector<ImportAnswer> answersTo(const fs::path& file, const std::vector<ImportOrder>& orders) {
    ImportAnswer read = guarded([&](ImportAnswer& told) {
        told.outcome = ImportOutcome::cuttable;
        told.model = readOrSayWhyNot(file);
        allowMending();
        weld(file, told.model, orders.front().means);
    });
    if (read.outcome != ImportOutcome::cuttable) {
        return std::vector<ImportAnswer>(orders.size(), read);
    }
    std::vector<ImportAnswer> answers;
    answers.reserve(orders.size());
    for (const ImportOrder& order : orders) {
        answers.push_back(guarded([&](ImportAnswer& told) {
            told.model = &order == &orders.back() ? std::move(read.model) : read.model;
            answer(order, told);
        }));
    }
    return answers;
}

ImportAnswer answerFor(const fs::path& file, ImportedModel model, const ImportOrder& order) {
    return guarded([&](ImportAnswer& told) {
        told.model = std::move(model);
        weld(file, told.model, order.means);
        answer(order, told);
    });
}

int runImport(const fs::path& file, const std::vector<std::string>& orders) {
    applyImportLimits();
    const int output = takeStandardOutput();
    std::vector<ImportOrder> decoded;
    std::ranges::transform(orders, std::back_inserter(decoded), decodeOrder);
    const std::vector<ImportAnswer> answers = answersTo(file, decoded);
    const auto write = [&](const ImportAnswer& told) {
        return writeAll(output, encodeAnswer(told));
    };
    return std::ranges::all_of(answers, write) ? 0 : 1;
}

}  // namespace kerf::app
