// Stands between Kerf and its OpenGL driver (LD_PRELOAD), and makes llvmpipe behave as other
// drivers may: KERF_QUIRK names how (quirk_shader.py lists what there is). A fault that a kernel
// reports ends the process with kFaultExit. scripts/test --quirk sets all that is needed.
#include <EGL/egl.h>
#include <dlfcn.h>
#include <glad/gl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Proc = __eglMustCastToProperFunctionPointerType;

constexpr int kFaultExit = 97;
constexpr int kRefused = 3;  // exit code of quirk_shader.py for what is no GLSL

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

const std::string& quirk() {
    static const std::string name = variable("KERF_QUIRK");
    return name;
}

/// Of the driver itself. Opened by name: a module of Python has its own scope.
Proc real(const char* name) {
    using Get = Proc (*)(const char*);
    static const auto get = reinterpret_cast<Get>(
        dlsym(dlopen("libEGL.so.1", RTLD_NOW | RTLD_GLOBAL), "eglGetProcAddress"));
    return get(name);
}

#define REAL(type, name) reinterpret_cast<type>(real(#name))

[[noreturn]] void stop(const std::string& why) {
    std::fprintf(stderr, "kerf quirk %s: %s\n", quirk().c_str(), why.c_str());
    std::fflush(stderr);
    _exit(kFaultExit);
}

// --- Shaders ------------------------------------------------------------------------------------

std::string hashOf(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const unsigned char letter : text) {
        hash = (hash ^ letter) * 0x100000001b3U;
    }
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    return digits.data();
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// From the folder KERF_QUIRK_SHADERS, where each kernel is rewritten once.
std::string rewritten(const std::string& text) {
    const fs::path folder = variable("KERF_QUIRK_SHADERS");
    const fs::path file = folder / (hashOf(text) + "." + quirk());
    if (!fs::exists(file)) {
        const std::string own = file.string() + "." + std::to_string(getpid());
        std::ofstream(own + ".comp") << text;
        const std::string command = "env -u LD_PRELOAD python3 '" +
                                    variable("KERF_QUIRK_REWRITER") + "' " + quirk() + " < '" +
                                    own + ".comp' > '" + own + "'";
        const int status = std::system(command.c_str());
        if (WIFEXITED(status) && WEXITSTATUS(status) == kRefused) {
            fs::remove(own);
            fs::remove(own + ".comp");
            return text;  // the driver says what is wrong with it
        }
        if (status != 0) {
            stop("a kernel could not be rewritten: " + own + ".comp");
        }
        fs::rename(own, file);
        fs::remove(own + ".comp");
    }
    return contentOf(file);
}

/// A kernel as its files name it: the comments of the loader.
struct Kernel {
    std::vector<std::string> files;

    std::string name() const { return files.empty() ? "a kernel" : files.front(); }
    std::string place(std::uint32_t site) const {
        constexpr std::uint32_t kLinesPerFile = 100000;
        const std::size_t file = site / kLinesPerFile;
        return (file < files.size() ? files[file] : "?") + ":" +
               std::to_string(site % kLinesPerFile);
    }
};

std::map<GLuint, Kernel> kernelOfShader;
std::map<GLuint, Kernel> kernelOfProgram;

Kernel kernelOf(const std::string& text) {
    constexpr std::string_view kBegin = "\n// file ";
    Kernel kernel;
    for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
        at += kBegin.size();
        const std::string name = text.substr(at, text.find('\n', at) - at);
        if (std::ranges::find(kernel.files, name) == kernel.files.end()) {
            kernel.files.push_back(name);
        }
    }
    return kernel;
}

void shaderSource(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
    GLint kind = 0;
    REAL(PFNGLGETSHADERIVPROC, glGetShaderiv)(shader, GL_SHADER_TYPE, &kind);
    const auto give = REAL(PFNGLSHADERSOURCEPROC, glShaderSource);
    if (kind != GL_COMPUTE_SHADER || count != 1 || lengths != nullptr) {
        return give(shader, count, texts, lengths);
    }
    const std::string text = *texts;
    kernelOfShader[shader] = kernelOf(text);
    const bool wanted =
        text.find("local_size_x") != std::string::npos &&
        kernelOfShader[shader].name().find(variable("KERF_QUIRK_ONLY")) != std::string::npos;
    const std::string ours = wanted ? rewritten(text) : text;
    const GLchar* first = ours.c_str();
    give(shader, 1, &first, nullptr);
}

void attachShader(GLuint program, GLuint shader) {
    if (const auto found = kernelOfShader.find(shader); found != kernelOfShader.end()) {
        kernelOfProgram[program] = found->second;
    }
    REAL(PFNGLATTACHSHADERPROC, glAttachShader)(program, shader);
}

/// Binaries are of kernels that were not rewritten, and none is kept of those that were.
void programBinary(GLuint program, GLenum, const void* binary, GLsizei length) {
    REAL(PFNGLPROGRAMBINARYPROC, glProgramBinary)(program, 0, binary, length);
}

void getProgramiv(GLuint program, GLenum name, GLint* value) {
    REAL(PFNGLGETPROGRAMIVPROC, glGetProgramiv)(program, name, value);
    if (name == GL_PROGRAM_BINARY_LENGTH) {
        *value = 0;
    }
}

/// Under quirks that may change the last digit it is another driver, so that results are held
/// against others' as those of another driver are.
const GLubyte* getString(GLenum name) {
    static std::string renderer;
    const GLubyte* there = REAL(PFNGLGETSTRINGPROC, glGetString)(name);
    if (name != GL_RENDERER || there == nullptr ||
        (quirk() != "denormals" && quirk() != "contraction")) {
        return there;
    }
    renderer = std::string(reinterpret_cast<const char*>(there)) + " with " + quirk();
    return reinterpret_cast<const GLubyte*>(renderer.c_str());
}

// --- Buffers ------------------------------------------------------------------------------------

void namedBufferStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    std::vector<std::uint32_t> garbage;
    if (quirk() == "garbage" && data == nullptr) {
        garbage.assign(static_cast<std::size_t>(size) / 4 + 1, 0x7fa1b2c3U);  // a signalling NaN
        data = garbage.data();
    }
    REAL(PFNGLNAMEDBUFFERSTORAGEPROC, glNamedBufferStorage)(buffer, size, data, flags);
}

// --- What kernels report ------------------------------------------------------------------------

// As in quirks.glsl.
constexpr GLuint kUnit = 63;
constexpr std::size_t kMostFaults = 64;
constexpr std::size_t kSlice = 2;
constexpr std::size_t kFirstFault = 8;
constexpr std::size_t kFirstBase = 512;
constexpr std::size_t kFirstStride = 768;
constexpr std::size_t kFirstSharedShadow = 1024;
constexpr std::size_t kFirstShadow = kFirstSharedShadow + std::size_t{2} * 16 * 8192;
constexpr std::size_t kWords = std::size_t{1} << 24;
constexpr GLuint kBlocks = 16;
constexpr GLuint kUnits = 32;

struct Watch {
    GLuint buffer = 0;
    GLuint texture = 0;
};

std::map<EGLContext, Watch> watches;

/// Of the current context.
const Watch& watch() {
    Watch& own = watches[eglGetCurrentContext()];
    if (own.buffer == 0) {
        REAL(PFNGLCREATEBUFFERSPROC, glCreateBuffers)(1, &own.buffer);
        const std::vector<std::uint32_t> zeros(quirk() == "races" ? kWords : kFirstSharedShadow);
        REAL(PFNGLNAMEDBUFFERSTORAGEPROC, glNamedBufferStorage)
        (own.buffer, static_cast<GLsizeiptr>(4 * zeros.size()), zeros.data(),
         GL_DYNAMIC_STORAGE_BIT);
        REAL(PFNGLCREATETEXTURESPROC, glCreateTextures)(GL_TEXTURE_BUFFER, 1, &own.texture);
        REAL(PFNGLTEXTUREBUFFERPROC, glTextureBuffer)(own.texture, GL_R32UI, own.buffer);
    }
    return own;
}

/// Into the file KERF_QUIRK_LOG, each line once: kernels that ran, and faults.
void log(const std::string& line) {
    static std::set<std::string> logged;
    static const std::string file = variable("KERF_QUIRK_LOG");
    if (!file.empty() && logged.insert(line).second) {
        std::ofstream(file, std::ios::app) << line + "\n";
    }
}

struct Bound {
    GLint buffer = 0;
    std::size_t first = 0;       ///< [bytes]
    std::uint32_t elements = 1;  ///< [words]
};

Bound boundBlock(GLuint binding) {
    Bound bound;
    GLint64 first = 0;
    REAL(PFNGLGETINTEGERI_VPROC, glGetIntegeri_v)
    (GL_SHADER_STORAGE_BUFFER_BINDING, binding, &bound.buffer);
    REAL(PFNGLGETINTEGER64I_VPROC, glGetInteger64i_v)
    (GL_SHADER_STORAGE_BUFFER_START, binding, &first);
    bound.first = static_cast<std::size_t>(first);
    return bound;
}

std::uint32_t wordsOf(GLint format) {
    return format == GL_R32UI ? 1 : (format == GL_RG32UI || format == GL_RG32F ? 2 : 4);
}

Bound boundTexels(GLuint unit) {
    Bound bound;
    GLint texture = 0;
    GLint format = 0;
    REAL(PFNGLGETINTEGERI_VPROC, glGetIntegeri_v)(GL_TEXTURE_BINDING_BUFFER, unit, &texture);
    if (texture != 0) {
        const auto get = REAL(PFNGLGETTEXTURELEVELPARAMETERIVPROC, glGetTextureLevelParameteriv);
        get(static_cast<GLuint>(texture), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &bound.buffer);
        get(static_cast<GLuint>(texture), 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
        bound.elements = wordsOf(format);
    }
    return bound;
}

std::size_t wordsIn(GLint buffer) {
    GLint64 size = 0;
    REAL(PFNGLGETNAMEDBUFFERPARAMETERI64VPROC, glGetNamedBufferParameteri64v)
    (static_cast<GLuint>(buffer), GL_BUFFER_SIZE, &size);
    return static_cast<std::size_t>(size) / 4;
}

/// Where the shadows of buffers begin, by binding (and 64 + unit), and the words of an element.
struct Shadows {
    std::array<std::uint32_t, 256> bases{};
    std::array<std::uint32_t, 256> strides{};
    std::size_t end = kFirstShadow;
};

/// Those that find no place are not watched.
Shadows placeShadows() {
    Shadows shadows;
    std::map<GLint, std::size_t> places;
    for (GLuint i = 0; i < kBlocks + kUnits; ++i) {
        const Bound bound = i < kBlocks ? boundBlock(i) : boundTexels(i - kBlocks);
        if (bound.buffer == 0 ||
            REAL(PFNGLISBUFFERPROC, glIsBuffer)(static_cast<GLuint>(bound.buffer)) == 0) {
            continue;
        }
        if (!places.contains(bound.buffer)) {
            const std::size_t words = wordsIn(bound.buffer);
            if (shadows.end + 2 * words > kWords) {
                log("not watched, for want of room, is a buffer of " + std::to_string(words) +
                    " words");
                continue;
            }
            places[bound.buffer] = shadows.end;
            shadows.end += 2 * words;
        }
        const GLuint at = i < kBlocks ? i : 64 + i - kBlocks;
        shadows.bases[at] = static_cast<std::uint32_t>(places[bound.buffer] + bound.first / 2);
        shadows.strides[at] = bound.elements;
    }
    return shadows;
}

void write(const Watch& own, std::size_t first, const void* words, std::size_t bytes) {
    REAL(PFNGLNAMEDBUFFERSUBDATAPROC, glNamedBufferSubData)
    (own.buffer, static_cast<GLintptr>(4 * first), static_cast<GLsizeiptr>(bytes), words);
}

/// Nobody has come to anything.
void layShadows(const Watch& own) {
    static std::uint32_t launches = 0;
    const Shadows shadows = placeShadows();
    const std::uint32_t slice = ++launches * 0x9e3779b1U >> 24;
    const GLuint zero = 0;
    REAL(PFNGLCLEARNAMEDBUFFERSUBDATAPROC, glClearNamedBufferSubData)
    (own.buffer, GL_R32UI, 4 * kFirstSharedShadow,
     static_cast<GLsizeiptr>(4 * (shadows.end - kFirstSharedShadow)), GL_RED_INTEGER,
     GL_UNSIGNED_INT, &zero);
    write(own, kFirstBase, shadows.bases.data(), sizeof shadows.bases);
    write(own, kFirstStride, shadows.strides.data(), sizeof shadows.strides);
    write(own, kSlice, &slice, sizeof slice);
}

GLuint currentProgram() {
    GLint program = 0;
    REAL(PFNGLGETINTEGERVPROC, glGetIntegerv)(GL_CURRENT_PROGRAM, &program);
    return static_cast<GLuint>(program);
}

struct Fault {
    std::uint32_t kind, site, a, b;
};

std::string invocationOf(std::uint32_t tag) {
    constexpr std::array<const char*, 4> kHow = {"", "read", "written", "changed atomically"};
    return std::string(kHow[tag & 3U]) + " by invocation " + std::to_string(tag >> 13 & 511U) +
           " of group " + std::to_string(tag >> 22) + " after " + std::to_string(tag >> 2 & 2047U) +
           " barriers";
}

std::string sentenceOf(const Fault& fault) {
    if (fault.kind == 1) {
        return "index " + std::to_string(fault.a) + " of " + std::to_string(fault.b);
    }
    if (fault.kind == 5) {
        return std::to_string(fault.a) + " accesses between barriers are too many to watch";
    }
    return fault.kind == 4 ? "a branch that is never taken was taken"
                           : "a word " + invocationOf(fault.a) + " was " + invocationOf(fault.b);
}

/// Ends the process where a kernel reported something; KERF_QUIRK_GOES_ON=1 only prints it.
void judge(const Watch& own, const Kernel& kernel) {
    REAL(PFNGLMEMORYBARRIERPROC, glMemoryBarrier)(GL_ALL_BARRIER_BITS);
    std::array<std::uint32_t, kFirstFault + 4 * kMostFaults> head{};
    REAL(PFNGLGETNAMEDBUFFERSUBDATAPROC, glGetNamedBufferSubData)
    (own.buffer, 0, sizeof head, head.data());
    if (head[0] == 0) {
        return;
    }
    static std::set<std::string> told;
    for (std::size_t i = 0; i < std::min<std::size_t>(head[0], kMostFaults); ++i) {
        const std::uint32_t* word = &head[kFirstFault + 4 * i];
        const Fault fault{word[0], word[1], word[2], word[3]};
        if (told.insert(kernel.place(fault.site)).second) {
            const std::string line =
                kernel.name() + ", " + kernel.place(fault.site) + ": " + sentenceOf(fault);
            std::fprintf(stderr, "kerf quirk %s: %s\n", quirk().c_str(), line.c_str());
            log(line);
        }
    }
    if (variable("KERF_QUIRK_GOES_ON") != "1") {
        stop(std::to_string(head[0]) + " faults in one launch");
    }
    const std::array<std::uint32_t, 2> none{};
    write(own, 0, none.data(), sizeof none);
}

template <class Launch>
void watched(Launch launch) {
    const Kernel kernel = kernelOfProgram[currentProgram()];
    log(kernel.name());
    if (quirk() != "races" && quirk() != "bounds" && quirk() != "dead") {
        return launch();
    }
    const Watch& own = watch();
    if (quirk() == "races") {
        layShadows(own);
    }
    REAL(PFNGLBINDIMAGETEXTUREPROC, glBindImageTexture)
    (kUnit, own.texture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    launch();
    judge(own, kernel);
}

void dispatchCompute(GLuint x, GLuint y, GLuint z) {
    watched([&] { REAL(PFNGLDISPATCHCOMPUTEPROC, glDispatchCompute)(x, y, z); });
}

void dispatchComputeIndirect(GLintptr offset) {
    watched([&] { REAL(PFNGLDISPATCHCOMPUTEINDIRECTPROC, glDispatchComputeIndirect)(offset); });
}

struct Replaced {
    std::string_view name;
    Proc ours;
};

template <class Function>
Replaced replaced(std::string_view name, Function* ours) {
    return {name, reinterpret_cast<Proc>(ours)};
}

}  // namespace

/// Another context may get its address.
extern "C" __attribute__((visibility("default"))) EGLBoolean eglDestroyContext(EGLDisplay display,
                                                                               EGLContext context) {
    watches.erase(context);
    const auto destroy = reinterpret_cast<PFNEGLDESTROYCONTEXTPROC>(
        dlsym(dlopen("libEGL.so.1", RTLD_NOW), "eglDestroyContext"));
    return destroy(display, context);
}

extern "C" __attribute__((visibility("default"))) Proc eglGetProcAddress(const char* name) {
    static const std::array<Replaced, 8> all = {
        replaced("glShaderSource", shaderSource),
        replaced("glAttachShader", attachShader),
        replaced("glProgramBinary", programBinary),
        replaced("glGetProgramiv", getProgramiv),
        replaced("glGetString", getString),
        replaced("glNamedBufferStorage", namedBufferStorage),
        replaced("glDispatchCompute", dispatchCompute),
        replaced("glDispatchComputeIndirect", dispatchComputeIndirect)};
    const auto* const found = std::ranges::find(all, name, &Replaced::name);
    const Proc there = real(name);
    return there == nullptr || quirk().empty() || found == all.end() ? there : found->ours;
}
