#include "python/errors.h"

#include <pybind11/pybind11.h>

#include <exception>

#include "app/cli/program.h"
#include "app/files/io/errors.h"
#include "python/gl_thread.h"
#include "python/scripted_run.h"
#include "sim/base/text.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

void raise(const char* kind, const std::string& sentence) {
    const py::object error = py::module_::import("kerf._errors").attr(kind);
    PyErr_SetString(error.ptr(), printable(sentence).c_str());
}

void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const CheckFailure& error) {
        raise("CheckFailed", error.what());
    } catch (const ForkedProcess& error) {
        raise("Error", error.what());
    } catch (...) {
        const auto [sentence, exitCode] = app::complaintAboutThrown();
        raise(exitCode == app::kExitInput      ? "InputError"
              : exitCode == app::kExitNoOpenGl ? "OpenGLError"
                                               : "LimitError",
              sentence);
    }
}

}  // namespace

void translateErrors() {
    py::register_exception_translator(translate);
}

}  // namespace kerf::python
