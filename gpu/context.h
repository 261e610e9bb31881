#pragma once

#include <stdexcept>

namespace kerf::gpu {

/// No usable OpenGL 4.5 core context: the message says what was tried and what to do.
class ContextError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The version that every context must have at least.
inline constexpr int kNeededMajor = 4;
inline constexpr int kNeededMinor = 5;

/// Whether the variable KERF_FORCE_NO_GL forbids making a context, for tests of what then happens.
bool isContextForbidden();

/// The driver's description of itself.
struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false;  ///< true for llvmpipe and softpipe: choose the light tier.
    int maxSamples = 1;     ///< GL_MAX_SAMPLES
};

/// A headless OpenGL 4.5 core context made through EGL: the device platform on a GPU driver,
/// surfaceless on Mesa. Current on the thread that made it until destroyed.
class EglContext {
  public:
    /// Throws ContextError.
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    /// Makes it current again after another one was. Throws ContextError.
    void makeCurrent();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Finds an OpenGL function by its name.
using ProcLoader = void (*(*)(const char* name))();

/// Loads the OpenGL functions of the context that is current on this thread, through
/// `getProcAddress` (glfwGetProcAddress, eglGetProcAddress). Throws ContextError if it is older
/// than 4.5 core.
void loadFunctions(ProcLoader getProcAddress);

/// The device that the current context runs on.
DeviceInfo queryDevice();

/// Routes OpenGL debug messages of severity low and above to the log and counts the errors.
/// The context should have been made with the debug flag to get all of them.
void enableDebugOutput();

/// Errors reported by the driver since the last call; tests assert that it is 0.
int takeDebugErrors();

/// The driver has reset the GPU under a running context: all its data is lost. A new context can be
/// made.
class ContextLost : public ContextError {
  public:
    using ContextError::ContextError;
};

/// Throws ContextLost where the driver has reset the GPU. It costs almost nothing, and is called
/// wherever results are read, so that those of a lost context are not used. The variable
/// KERF_LOSE_CONTEXT=FILE, for tests, simulates a reset as soon as that file exists, and removes
/// it.
void requireContext();

/// A limit of a driver, and the least value for Kerf's shaders.
struct DriverLimit {
    const char* name;    ///< as OpenGL has it
    const char* phrase;  ///< for messages: "storage buffers in a compute shader"
    std::int64_t has = 0;
    std::int64_t needs = 0;
};

/// The limits of the driver of the current context that Kerf's shaders may reach.
std::vector<DriverLimit> driverLimits();

/// What a driver lacks and what to do, in one sentence; empty if nothing.
std::string sentenceOfLack(std::span<const DriverLimit> limits);

}  // namespace kerf::gpu
