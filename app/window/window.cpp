#include "app/window/window.h"

#include <dlfcn.h>
#include <glad/gl.h>

#include <cstring>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <spdlog/spdlog.h>

#include "app/files/io/file_io.h"
#include "app/window/monitor.h"
#include "gpu/context.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

constexpr int kPreferredWidth = 1600;
constexpr int kPreferredHeight = 900;
// Below that the panels have no room.
constexpr int kLeastWidth = 480;
constexpr int kLeastHeight = 270;

// In the order of ui::Cursor.
constexpr std::array<int, ui::kCursors> kShapes{GLFW_ARROW_CURSOR,   GLFW_IBEAM_CURSOR,
                                                GLFW_HAND_CURSOR,    GLFW_CROSSHAIR_CURSOR,
                                                GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};

std::string lastGlfwError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

/// Whether the desktop names a scale, which GLFW reports: on X by the resource Xft.dpi. The
/// functions are those of the libraries that GLFW has loaded; it may be built without X.
bool namesScale() {
    const auto display = reinterpret_cast<void* (*)()>(dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
    const auto resources =
        reinterpret_cast<const char* (*)(void*)>(dlsym(RTLD_DEFAULT, "XResourceManagerString"));
    if (display == nullptr || resources == nullptr || display() == nullptr) {
        return true;
    }
    const char* const text = resources(display());
    return text != nullptr && std::strstr(text, "Xft.dpi") != nullptr;
}

/// The first one first.
std::vector<Monitor> monitorsNow() {
    int count = 0;
    GLFWmonitor** const all = glfwGetMonitors(&count);
    std::vector<Monitor> monitors(count);
    for (int i = 0; i < count; ++i) {
        Monitor& m = monitors[i];
        glfwGetMonitorWorkarea(all[i], &m.x, &m.y, &m.width, &m.height);
        int wide = 0;
        int high = 0;
        glfwGetMonitorPhysicalSize(all[i], &wide, &high);
        if (const GLFWvidmode* const mode = glfwGetVideoMode(all[i]); mode && !namesScale()) {
            m.scale = scaleOf(mode->width, mode->height, wide, high);
        }
    }
    return monitors;
}

[[noreturn]] void failToOpen(const std::string& reason) {
    throw gpu::ContextError(
        "No window can be opened (" + reason +
        "): start Kerf on a display with OpenGL 4.5, or use \"kerf replay\", which "
        "needs none.");
}

ui::Key offset(ui::Key first, int by) {
    return static_cast<ui::Key>(static_cast<int>(first) + by);
}

ui::Key namedKey(int key) {
    static constexpr std::array<std::pair<int, ui::Key>, 23> kKeys{{
        {GLFW_KEY_SPACE, ui::Key::space},    {GLFW_KEY_ENTER, ui::Key::enter},
        {GLFW_KEY_KP_ENTER, ui::Key::enter}, {GLFW_KEY_ESCAPE, ui::Key::escape},
        {GLFW_KEY_TAB, ui::Key::tab},        {GLFW_KEY_BACKSPACE, ui::Key::backspace},
        {GLFW_KEY_DELETE, ui::Key::del},     {GLFW_KEY_INSERT, ui::Key::insert},
        {GLFW_KEY_LEFT, ui::Key::left},      {GLFW_KEY_RIGHT, ui::Key::right},
        {GLFW_KEY_UP, ui::Key::up},          {GLFW_KEY_DOWN, ui::Key::down},
        {GLFW_KEY_PAGE_UP, ui::Key::pageUp}, {GLFW_KEY_PAGE_DOWN, ui::Key::pageDown},
        {GLFW_KEY_HOME, ui::Key::home},      {GLFW_KEY_END, ui::Key::end},
        {GLFW_KEY_PERIOD, ui::Key::period},  {GLFW_KEY_KP_DECIMAL, ui::Key::period},
        {GLFW_KEY_SLASH, ui::Key::slash},    {GLFW_KEY_MINUS, ui::Key::minus},
        {GLFW_KEY_EQUAL, ui::Key::equal},    {GLFW_KEY_KP_SUBTRACT, ui::Key::minus},
        {GLFW_KEY_KP_ADD, ui::Key::equal},
    }};
    const auto* row = std::ranges::find(kKeys, key, &std::pair<int, ui::Key>::first);
    return row == kKeys.end() ? ui::Key::none : row->second;
}

/// A letter is the one that the keyboard layout writes, not the place where it lies.
int layoutKey(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    const bool oneLetter = name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0;
    return oneLetter ? GLFW_KEY_A + (name[0] - 'a') : key;
}

ui::Key toKey(int glfwKey, int scancode) {
    const int key = layoutKey(glfwKey, scancode);
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
        return offset(ui::Key::a, key - GLFW_KEY_A);
    }
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
        return offset(ui::Key::digit0, key - GLFW_KEY_0);
    }
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
        return offset(ui::Key::digit0, key - GLFW_KEY_KP_0);
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) {
        return offset(ui::Key::f1, key - GLFW_KEY_F1);
    }
    return namedKey(key);
}

ui::Modifiers toModifiers(int bits) {
    return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0,
            (bits & GLFW_MOD_ALT) != 0};
}

}  // namespace

struct Window::State {
    GLFWwindow* window = nullptr;
    std::function<void(ui::InputEvent)> receive;
    std::string title;
    bool damaged = true;
    ui::Modifiers modifiers;  ///< as of the last event that told them
    std::array<GLFWcursor*, ui::kCursors> cursors{};
    ui::Cursor cursor = ui::Cursor::arrow;  ///< that is shown
    ui::WindowPlace place;                  ///< the last one that was not maximized
    float scale = 1;                        ///< of its monitor, where the desktop names none

    static State& of(GLFWwindow* window) {
        return *static_cast<State*>(glfwGetWindowUserPointer(window));
    }
    void send(ui::InputEvent event) const {
        if (receive) {
            receive(std::move(event));
        }
    }

    static void onMove(GLFWwindow* window, double x, double y);
    static void onButton(GLFWwindow* window, int button, int action, int bits);
    static void onWheel(GLFWwindow* window, double x, double y);
    static void onKey(GLFWwindow* window, int key, int scancode, int action, int bits);
    static void onCharacter(GLFWwindow* window, unsigned code);
    static void onDrop(GLFWwindow* window, int count, const char** files);
    static void onFocus(GLFWwindow* window, int focused);
    static void onRefresh(GLFWwindow* window);
    static void onResize(GLFWwindow* window, int width, int height);
    static void onPlace(GLFWwindow* window, int x, int y);

    void open(const std::string& name, const ui::WindowPlace& former);
    void followPlace();
    void prepareContext() const;
    void connect();
};

void Window::State::onMove(GLFWwindow* window, double x, double y) {
    // Where the display is scaled, the pointer may come in other units than the picture.
    int pictureWidth = 0;
    int pictureHeight = 0;
    int windowWidth = 0;
    int windowHeight = 0;
    glfwGetFramebufferSize(window, &pictureWidth, &pictureHeight);
    glfwGetWindowSize(window, &windowWidth, &windowHeight);
    if (windowWidth > 0 && windowHeight > 0) {
        const State& state = of(window);
        state.send(ui::PointerMove{x * pictureWidth / windowWidth, y * pictureHeight / windowHeight,
                                   state.modifiers});
    }
}

void Window::State::onButton(GLFWwindow* window, int button, int action, int bits) {
    if (button >= ui::kButtons) {
        return;
    }
    State& state = of(window);
    state.modifiers = toModifiers(bits);
    static constexpr std::array<ui::Button, ui::kButtons> kButtonOf{
        ui::Button::left, ui::Button::right, ui::Button::middle};
    state.send(ui::ButtonChange{kButtonOf[button], action == GLFW_PRESS, state.modifiers});
}

void Window::State::onWheel(GLFWwindow* window, double x, double y) {
    of(window).send(ui::Wheel{x, y});
}

void Window::State::onKey(GLFWwindow* window, int key, int scancode, int action, int bits) {
    State& state = of(window);
    state.modifiers = toModifiers(bits);
    const ui::Key known = toKey(key, scancode);
    if (action != GLFW_REPEAT) {
        state.send(ui::KeyChange{known, action == GLFW_PRESS, state.modifiers});
    } else {
        state.damaged = true;  // a text field repeats by itself, but only from picture to picture
    }
}

void Window::State::onCharacter(GLFWwindow* window, unsigned code) {
    of(window).send(ui::Character{code});
}

void Window::State::onDrop(GLFWwindow* window, int count, const char** files) {
    ui::FileDrop drop;
    drop.files.assign(files, files + count);
    of(window).send(std::move(drop));
}

void Window::State::onFocus(GLFWwindow* window, int focused) {
    if (focused == GLFW_FALSE) {
        of(window).send(ui::FocusLost{});
    }
}

void Window::State::onRefresh(GLFWwindow* window) {
    of(window).damaged = true;
}

void Window::State::onResize(GLFWwindow* window, int /*width*/, int /*height*/) {
    of(window).damaged = true;
    of(window).followPlace();
}

void Window::State::onPlace(GLFWwindow* window, int /*x*/, int /*y*/) {
    of(window).followPlace();
}

void Window::State::followPlace() {
    ui::WindowPlace now{.maximized = glfwGetWindowAttrib(window, GLFW_MAXIMIZED) == GLFW_TRUE};
    glfwGetWindowPos(window, &now.x, &now.y);
    glfwGetWindowSize(window, &now.width, &now.height);
    const std::vector<Monitor> monitors = monitorsNow();
    if (const Monitor* const monitor = monitorOf(now, monitors)) {
        scale = monitor->scale;
    }
    if (!now.maximized && glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_FALSE) {
        place = now;
    }
    place.maximized = now.maximized;
}

void Window::State::open(const std::string& name, const ui::WindowPlace& former) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, gpu::kNeededMajor);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, gpu::kNeededMinor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // The picture is drawn off-screen: the window needs neither depth nor samples of its own.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // where it is offered
    const std::vector<Monitor> monitors = monitorsNow();
    const Monitor* const again = monitorOf(former, monitors);
    const Monitor area = again ? *again : monitors.empty() ? Monitor{} : monitors.front();
    place = {0, 0, static_cast<int>(kPreferredWidth * area.scale),
             static_cast<int>(kPreferredHeight * area.scale)};
    place = area.width > 0 ? fitted(again ? former : place, area) : place;
    const auto [x, y, width, height, maximized] = place;
    scale = area.scale;
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, again ? GLFW_FALSE : GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, again ? GLFW_FALSE : GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, maximized ? GLFW_TRUE : GLFW_FALSE);
    window = glfwCreateWindow(width, height, name.c_str(), nullptr, nullptr);
    if (window == nullptr) {
        failToOpen(lastGlfwError());
    }
    glfwSetWindowSizeLimits(window, std::min(width, kLeastWidth), std::min(height, kLeastHeight),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (again != nullptr) {
        glfwSetWindowPos(window, x, y);
        glfwShowWindow(window);
    }
    title = name;
    try {
        render::Image icon = windowIcon();
        const GLFWimage image{icon.width, icon.height, icon.pixels.data()};
        glfwSetWindowIcon(window, 1, &image);
    } catch (const InputError& error) {
        spdlog::warn("The window has no icon: {}", error.what());
    }
    for (std::size_t i = 0; i < kShapes.size(); ++i) {
        cursors[i] = glfwCreateStandardCursor(kShapes[i]);
    }
}

void Window::State::prepareContext() const {
    glfwMakeContextCurrent(window);
    gpu::loadFunctions(glfwGetProcAddress);
    glfwSwapInterval(1);
}

void Window::State::connect() {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, onMove);
    glfwSetMouseButtonCallback(window, onButton);
    glfwSetScrollCallback(window, onWheel);
    glfwSetKeyCallback(window, onKey);
    glfwSetCharCallback(window, onCharacter);
    glfwSetDropCallback(window, onDrop);
    glfwSetWindowFocusCallback(window, onFocus);
    glfwSetWindowRefreshCallback(window, onRefresh);
    glfwSetFramebufferSizeCallback(window, onResize);
    glfwSetWindowPosCallback(window, onPlace);
    followPlace();
}

render::Image windowIcon() {
    return readPicture(gpu::dataPath("assets/window/icon.png"));
}

Window::Window(const std::string& title, const ui::WindowPlace& former)
    : state_(std::make_unique<State>()) {
    if (gpu::isContextForbidden()) {
        failToOpen("KERF_FORCE_NO_GL is set");
    }
    if (glfwInit() != GLFW_TRUE) {
        failToOpen(lastGlfwError());
    }
    try {
        state_->open(title, former);
        state_->prepareContext();
        state_->connect();
    } catch (...) {
        glfwTerminate();
        throw;
    }
}

Window::~Window() {
    glfwTerminate();
}

void Window::onInput(std::function<void(ui::InputEvent)> receive) {
    state_->receive = std::move(receive);
}

int Window::width() const {
    int width = 0;
    glfwGetFramebufferSize(state_->window, &width, nullptr);
    return width;
}

int Window::height() const {
    int height = 0;
    glfwGetFramebufferSize(state_->window, nullptr, &height);
    return height;
}

float Window::scale() const {
    float named = 1;
    glfwGetWindowContentScale(state_->window, &named, nullptr);
    return std::clamp(named * state_->scale, 0.5F, 4.0F);
}

const ui::WindowPlace& Window::place() const {
    return state_->place;
}

void Window::setTitle(const std::string& title) {
    if (title != state_->title) {
        state_->title = title;
        glfwSetWindowTitle(state_->window, title.c_str());
    }
}

void Window::setCursor(ui::Cursor cursor) {
    if (std::exchange(state_->cursor, cursor) != cursor) {
        glfwSetCursor(state_->window, state_->cursors[static_cast<std::size_t>(cursor)]);
    }
}

bool Window::closing() const {
    return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}

bool Window::hidden() const {
    return glfwGetWindowAttrib(state_->window, GLFW_ICONIFIED) == GLFW_TRUE ||
           glfwGetWindowAttrib(state_->window, GLFW_VISIBLE) == GLFW_FALSE;
}

void Window::stayOpen() {
    glfwSetWindowShouldClose(state_->window, GLFW_FALSE);
}

bool Window::takeDamage() {
    return std::exchange(state_->damaged, false);
}

void Window::waitEvents(double seconds) {
    if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::show(const gpu::Framebuffer& picture) {
    // Mesa's software drivers learn the window's new size when it is bound to draw into, and not
    // from a blit.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBlitNamedFramebuffer(picture.id(), 0, 0, 0, picture.width(), picture.height(), 0, 0, width(),
                           height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(state_->window);
}

}  // namespace kerf::app
