#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/cli/replay/replay.h"
#include "app/files/import/model_source.h"
#include "app/files/io/memory_means.h"
#include "gpu/context.h"
#include "python/bindings.h"
#include "python/gl_thread.h"
#include "python/log.h"
#include "python/session_source.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// Somebody asked the replay to stop.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// As `kerf replay`: its `--json`, on a context of its own.
std::string replay(const SessionSource& source, const std::filesystem::path& folder,
                   const app::ReplayOptions& options) {
    const app::Session session = readSource(source);
    app::ReadOptions reading;
    reading.means = app::memoryMeans();
    app::ModelMesh model = app::loadSessionModel(session, reading);
    const gpu::EglContext context;
    gpu::enableDebugOutput();
    app::ReplayListener listener;
    listener.progress = [](int, int) {
        if (GlThread::ours().interrupted()) {
            throw Interrupted();
        }
    };
    const app::ReplayResult result =
        app::replaySession(session, std::move(model), folder, listener, options);
    nlohmann::ordered_json json = toJson(result.summary);
    json["files"] = result.files;
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void addReplay(py::module_& module) {
    py::class_<app::ReplayOptions>(module, "ReplayOptions")
        .def(py::init())
        .def_readwrite("hashes", &app::ReplayOptions::hashes)
        .def_readwrite("pieces", &app::ReplayOptions::pieces)
        .def_readwrite("forces", &app::ReplayOptions::forces)
        .def_readwrite("until", &app::ReplayOptions::until)
        .def_readwrite("keep_going", &app::ReplayOptions::keepGoing)
        .def_readwrite("hash_checks", &app::ReplayOptions::hashChecks)
        .def("set_fine", [](app::ReplayOptions& options, bool fine) {
            options.quality = fine ? render::Quality::full : render::Quality::light;
        });
    module.def("replay", [](const SessionSource& source, const std::string& folder,
                            const app::ReplayOptions& options) {
        const LogDelivery delivery;
        return GlThread::ours().run([&] { return replay(source, folder, options); });
    });
}

}  // namespace kerf::python
