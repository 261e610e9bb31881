#include <pybind11/stl.h>

#include "app/files/io/errors.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/gl_thread.h"
#include "python/log.h"
#include "python/scripted_run.h"
#include "python/session_source.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// A run as Python holds it: all is done on GlThread, where its context is made current first.
class RunHandle {
  public:
    RunHandle(const SessionSource& source, const RunOptions& options)
        : run_(begin(source, options)) {}
    ~RunHandle() { dropOn(std::move(run_), nullptr); }
    RunHandle(const RunHandle&) = delete;
    RunHandle& operator=(const RunHandle&) = delete;

    /// What `work` returns of the run.
    template <class Work>
    auto on(Work work) {
        const LogDelivery delivery;
        return GlThread::ours().run([&] {
            run_->makeCurrent();
            return work(*run_);
        });
    }

    /// A moment of a run, which keeps the run.
    class Moment {
      public:
        Moment(std::shared_ptr<ScriptedRun> run, std::shared_ptr<const ScriptedRun::Snapshot> what)
            : run_(std::move(run)), what_(std::move(what)) {}
        ~Moment() { dropOn(std::move(run_), std::move(what_)); }
        Moment(const Moment&) = delete;
        Moment& operator=(const Moment&) = delete;

        const ScriptedRun* run() const { return run_.get(); }
        const ScriptedRun::Snapshot& what() const { return *what_; }

      private:
        std::shared_ptr<ScriptedRun> run_;
        std::shared_ptr<const ScriptedRun::Snapshot> what_;
    };
    std::unique_ptr<Moment> snapshot() {
        return std::make_unique<Moment>(run_, on([](auto& run) { return run.snapshot(); }));
    }
    void restore(const Moment& moment) {
        if (moment.run() != run_.get()) {
            throw app::InputError("The snapshot is of another simulation.");
        }
        on([&](auto& run) { run.restore(moment.what()); });
    }

  private:
    static std::shared_ptr<ScriptedRun> begin(const SessionSource& source,
                                              const RunOptions& options) {
        const LogDelivery delivery;
        return GlThread::ours().run(
            [&] { return std::make_shared<ScriptedRun>(readSource(source), options); });
    }

    /// Buffers go where they are from.
    static void dropOn(std::shared_ptr<ScriptedRun> run,
                       std::shared_ptr<const ScriptedRun::Snapshot> moment) {
        GlThread::ours().post([run = std::move(run), moment = std::move(moment)]() mutable {
            run->makeCurrent();
            moment.reset();
            run.reset();
        });
    }

    std::shared_ptr<ScriptedRun> run_;
};

py::object asPython(const ParamValue& value) {
    const auto convert = [](const auto& v) -> py::object {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, std::monostate>) {
            return py::none();
        } else if constexpr (std::is_same_v<Value, Vec3>) {
            return py::make_tuple(v[0], v[1], v[2]);
        } else {
            return py::cast(v);
        }
    };
    return std::visit(convert, value);
}

py::tuple asPython(const Vec3& v) {
    return py::make_tuple(v[0], v[1], v[2]);
}

py::object bladeOf(RunHandle& handle) {
    const std::optional<Blade> blade = handle.on([](auto& run) { return run.blade(); });
    return blade ? py::object(py::make_tuple(asPython(blade->a), asPython(blade->b))) : py::none();
}

py::list boxesOf(RunHandle& handle) {
    py::list list;
    for (const StaticBox& box : handle.on([](auto& run) { return run.boxes(); })) {
        py::dict entry;
        entry["center"] = asPython(box.center);
        entry["size"] = asPython(box.size);
        entry["rotate"] = asPython(box.rotate);
        list.append(entry);
    }
    return list;
}

py::object pictureOf(RunHandle& handle, const std::string& size, const std::string& view) {
    render::Image image = handle.on([&](auto& run) { return run.picture(size, view); });
    return arrayOf(NumberBlock(std::move(image.pixels)), image.height, image.width, 4);
}

app::MetricsRow stepsOf(RunHandle& handle, int count) {
    return handle.on([count](ScriptedRun& run) {
        for (int i = 0; i < count && !GlThread::ours().interrupted(); ++i) {
            run.step();
        }
        return run.row();
    });
}

py::tuple trianglesOf(RunHandle& handle) {
    const TriangleArrays arrays = handle.on([](auto& run) { return run.triangles(); });
    return py::make_tuple(tableOf(arrays.corners), listOf(arrays.isWall), listOf(arrays.piece),
                          tableOf(arrays.restPositions));
}

py::tuple piecesOf(RunHandle& handle) {
    const PieceArrays arrays = handle.on([](auto& run) { return run.pieces(); });
    return py::make_tuple(listOf(arrays.triangles), listOf(arrays.model), listOf(arrays.volume),
                          listOf(arrays.restVolume), tableOf(arrays.low), tableOf(arrays.high));
}

}  // namespace

void addRun(py::module_& module) {
    py::class_<NumberBlock>(module, "_NumberBlock", py::buffer_protocol())
        .def_buffer(&NumberBlock::info);
    py::class_<SessionSource>(module, "SessionSource")
        .def(py::init([](std::string file, std::string text, std::string material,
                         std::vector<std::pair<std::string, std::string>> params) {
                 return SessionSource{std::move(file), std::move(text), std::move(material),
                                      std::move(params)};
             }),
             py::arg("file"), py::arg("text"), py::arg("material"), py::arg("params"));
    const py::class_<RunHandle::Moment> snapshot(
        module, "Snapshot", "A state of a simulation, which it can return to.");
    py::class_<RunHandle>(module, "Run")
        .def(py::init([](const SessionSource& source, std::size_t undoBudget, bool fine,
                         bool forces, bool hashChecks) {
                 return std::make_unique<RunHandle>(
                     source, RunOptions{undoBudget, fine, forces, hashChecks});
             }),
             py::arg("source"), py::arg("undo_memory"), py::arg("fine"), py::arg("forces"),
             py::arg("hash_checks"))
        .def("apply",
             [](RunHandle& h, const std::string& action) {
                 h.on([&](auto& run) { run.apply(action); });
             })
        .def("step", stepsOf, py::arg("count"))
        .def("finish", [](RunHandle& h) { h.on([](auto& run) { run.finish(); }); })
        .def("snapshot", &RunHandle::snapshot)
        .def("restore", &RunHandle::restore)
        .def("report", [](RunHandle& h) { return h.on([](auto& run) { return run.row(); }); })
        .def("step_count",
             [](RunHandle& h) { return h.on([](auto& run) { return run.stepCount(); }); })
        .def("steps", [](RunHandle& h) { return h.on([](auto& run) { return run.steps(); }); })
        .def("param",
             [](RunHandle& h, const std::string& name) {
                 return asPython(h.on([&](auto& run) { return run.param(name); }));
             })
        .def("blade", bladeOf)
        .def("boxes", boxesOf)
        .def("state_hash",
             [](RunHandle& h) { return h.on([](auto& run) { return run.stateHash(); }); })
        .def("positions",
             [](RunHandle& h) { return tableOf(h.on([](auto& run) { return run.positions(); })); })
        .def("velocities",
             [](RunHandle& h) { return tableOf(h.on([](auto& run) { return run.velocities(); })); })
        .def("strains",
             [](RunHandle& h) { return listOf(h.on([](auto& run) { return run.strains(); })); })
        .def("triangles", trianglesOf)
        .def("pieces", piecesOf)
        .def("pinned",
             [](RunHandle& h) {
                 return listOf(h.on([](auto& run) { return run.pinnedVertices(); }));
             })
        .def("cut_report",
             [](RunHandle& h) { return h.on([](auto& run) { return run.cutReport(); }); })
        .def("messages",
             [](RunHandle& h) { return h.on([](auto& run) { return run.messages(); }); })
        .def("tear_sentence",
             [](RunHandle& h) { return h.on([](auto& run) { return run.tearSentence(); }); })
        .def("picture", pictureOf)
        .def("export",
             [](RunHandle& h, const std::string& folder, const std::string& event) {
                 return h.on([&](auto& run) { return run.exportMesh(folder, event); });
             })
        .def("save_session", [](RunHandle& h, const std::string& file) {
            h.on([&](auto& run) { run.saveSession(file); });
        });
}

}  // namespace kerf::python
