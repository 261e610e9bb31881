#include "python/errors.h"

#include <exception>

#include "app/cli/program.h"
#include "app/files/io/errors.h"
#include "python/gl_thread.h"
#include "python/scripted_run.h"
#include "sim/base/text.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// The classes, as long as the interpreter lives.
struct ErrorClasses {
    PyObject* any = nullptr;
    PyObject* input = nullptr;
    PyObject* check = nullptr;
    PyObject* openGl = nullptr;
    PyObject* limit = nullptr;
};
ErrorClasses classes;

PyObject* addClass(py::module_& module, const char* name, const char* meaning, PyObject* base) {
    const std::string whole = std::string("kerf.") + name;
    PyObject* const made = PyErr_NewExceptionWithDoc(whole.c_str(), meaning, base, nullptr);
    if (made == nullptr) {
        throw py::error_already_set();
    }
    module.add_object(name, made);
    return made;
}

void raise(PyObject* kind, const std::string& sentence) {
    PyErr_SetString(kind, printable(sentence).c_str());
}

void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const CheckFailure& error) {
        raise(classes.check, error.what());
    } catch (const ForkedProcess& error) {
        raise(classes.any, error.what());
    } catch (...) {
        const auto [sentence, exitCode] = app::complaintAboutThrown();
        raise(exitCode == app::kExitInput      ? classes.input
              : exitCode == app::kExitNoOpenGl ? classes.openGl
                                               : classes.limit,
              sentence);
    }
}

}  // namespace

void addErrors(py::module_& module) {
    classes.any =
        addClass(module, "Error", "Any failure of Kerf, with the message of the command line.",
                 PyExc_Exception);
    classes.input =
        addClass(module, "InputError", "An input is missing, invalid or impossible (exit code 3).",
                 classes.any);
    classes.check = addClass(module, "CheckFailed",
                             "A check or an invariant failed (exit code 1). Of a replay, "
                             "`summary` is that of the run.",
                             classes.any);
    classes.openGl =
        addClass(module, "OpenGLError", "No usable OpenGL 4.5 (exit code 4).", classes.any);
    classes.limit =
        addClass(module, "LimitError",
                 "Memory, disk, time or another limit is used up (exit code 5).", classes.any);
    py::register_exception_translator(translate);
}

}  // namespace kerf::python
