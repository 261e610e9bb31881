#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <spdlog/spdlog.h>

#include <cstdlib>

#include "gpu/context.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

/// A way to a display: what to call it in messages, and the arguments of eglGetPlatformDisplay.
struct Route {
    std::string name;
    EGLenum platform;
    void* nativeDisplay;
};

/// The first reason why a route did not lead to a context.
struct RouteFailure {
    std::string reason;
};

bool environmentSwitch(const char* name) {
    const char* variable = std::getenv(name);
    const std::string_view value = variable == nullptr ? "" : variable;
    return !value.empty() && value != "0" && value != "false";
}

bool hasWord(const char* list, std::string_view word) {
    const std::string padded = " " + std::string(list == nullptr ? "" : list) + " ";
    return padded.find(" " + std::string(word) + " ") != std::string::npos;
}

template <class Function>
Function extensionFunction(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> listDevices() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasWord(client, "EGL_EXT_device_base") && !hasWord(client, "EGL_EXT_device_enumeration")) {
        return {};
    }
    auto query = extensionFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (query == nullptr || query(0, nullptr, &count) == EGL_FALSE) {
        return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    query(count, devices.data(), &count);
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

bool isSoftwareDevice(EGLDeviceEXT device) {
    auto query = extensionFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return query != nullptr && hasWord(query(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

/// GPUs first, then Mesa's surfaceless platform; software devices come last because they are the
/// same renderer by a path that fewer drivers offer. LIBGL_ALWAYS_SOFTWARE leaves the GPUs out.
std::vector<Route> routes() {
    std::vector<Route> hardware;
    std::vector<Route> software;
    for (EGLDeviceEXT device : listDevices()) {
        std::vector<Route>& kind = isSoftwareDevice(device) ? software : hardware;
        const char* name = isSoftwareDevice(device) ? "software device " : "GPU device ";
        kind.push_back({name + std::to_string(kind.size()), EGL_PLATFORM_DEVICE_EXT, device});
    }
    if (environmentSwitch("LIBGL_ALWAYS_SOFTWARE")) {
        hardware.clear();
    }
    std::vector<Route> all = std::move(hardware);
    all.push_back({"Mesa surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr});
    all.insert(all.end(), software.begin(), software.end());
    return all;
}

std::string eglFailure(std::string_view call) {
    constexpr std::array<std::pair<EGLint, const char*>, 6> kNames = {
        {{EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
         {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
         {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
         {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
         {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
         {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"}}};
    const EGLint error = eglGetError();
    for (const auto& [code, name] : kNames) {
        if (code == error) {
            return std::string(call) + " failed with " + name;
        }
    }
    return fmt::format("{} failed with EGL error 0x{:x}", call, error);
}

EGLDisplay openDisplay(const Route& route) {
    EGLDisplay display = eglGetPlatformDisplay(route.platform, route.nativeDisplay, nullptr);
    if (display == EGL_NO_DISPLAY) {
        throw RouteFailure{eglFailure("eglGetPlatformDisplay")};
    }
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        throw RouteFailure{eglFailure("eglInitialize")};
    }
    if (!hasWord(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
        throw RouteFailure{"no EGL_KHR_surfaceless_context"};
    }
    return display;
}

EGLConfig chooseConfig(EGLDisplay display) {
    const std::array<EGLint, 5> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                          EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted.data(), &config, 1, &count);
    if (count == 0) {
        throw RouteFailure{"no configuration for desktop OpenGL"};
    }
    return config;
}

EGLContext createContext(EGLDisplay display, bool debug) {
    eglBindAPI(EGL_OPENGL_API);
    // What stands behind is left out where the driver does not offer it.
    std::array<EGLint, 13> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                     kNeededMajor,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     kNeededMinor,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_DEBUG,
                                     debug ? EGL_TRUE : EGL_FALSE,
                                     EGL_CONTEXT_OPENGL_ROBUST_ACCESS,
                                     EGL_TRUE,
                                     EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                     EGL_LOSE_CONTEXT_ON_RESET,
                                     EGL_NONE};
    const EGLConfig config = chooseConfig(display);
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
    for (const std::size_t left : {wanted.size() - 3, wanted.size() - 5}) {
        if (context == EGL_NO_CONTEXT) {
            spdlog::debug("{}: with fewer", eglFailure("eglCreateContext with all attributes"));
            wanted[left] = EGL_NONE;
            context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
        }
    }
    if (context == EGL_NO_CONTEXT) {
        throw RouteFailure{eglFailure("eglCreateContext for OpenGL 4.5 core")};
    }
    return context;
}

}  // namespace

/// The display is shared by all contexts of the process, so that it stays initialized to the end.
struct EglContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    State(const Route& route, bool debug)
        : display(openDisplay(route)), context(createContext(display, debug)) {
        try {
            makeCurrent();
            loadFunctions(eglGetProcAddress);
        } catch (const ContextError& error) {
            destroy();
            throw RouteFailure{error.what()};
        } catch (const RouteFailure&) {
            destroy();
            throw;
        }
    }
    ~State() { destroy(); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void makeCurrent() const {
        eglBindAPI(EGL_OPENGL_API);
        if (eglGetCurrentContext() == context) {
            return;  // drivers may flush what was told to it
        }
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
            throw RouteFailure{eglFailure("eglMakeCurrent")};
        }
        noteOtherContext();
    }

    void destroy() const {
        if (eglGetCurrentContext() == context) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
    }
};

bool isContextForbidden() {
    return environmentSwitch("KERF_FORCE_NO_GL");
}

EglContext::EglContext() {
    if (isContextForbidden()) {
        throw ContextError(
            "No OpenGL 4.5 context: it is switched off by KERF_FORCE_NO_GL; unset that variable.");
    }
    const bool debug = environmentSwitch("KERF_GL_DEBUG");
    std::string tried;
    for (const Route& route : routes()) {
        try {
            state_ = std::make_unique<State>(route, debug);
            spdlog::debug("OpenGL through EGL: {}", route.name);
            if (debug) {
                enableDebugOutput();
            }
            return;
        } catch (const RouteFailure& failure) {
            tried += (tried.empty() ? "" : "; ") + route.name + " (" + failure.reason + ")";
        }
    }
    throw ContextError("No OpenGL 4.5 core context could be made through EGL. Tried: " + tried +
                       ". Install a graphics driver with OpenGL 4.5, or Mesa's software renderer "
                       "(apt install libegl1 libgl1-mesa-dri).");
}

EglContext::~EglContext() = default;

void EglContext::makeCurrent() {
    try {
        state_->makeCurrent();
    } catch (const RouteFailure& failure) {
        throw ContextError("The OpenGL context was lost: " + failure.reason + ".");
    }
}

}  // namespace kerf::gpu
