// Pictures of the editor, to look at and for the README: the whole window and each panel, at both
// scales and in both themes. Usage: kerf_pictures DIR
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/editor/editor.h"
#include "app/editor/storage/settings_file.h"
#include "app/editor/view/start_scenes.h"
#include "app/files/io/file_io.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/base/stopwatch.h"
#include "ui/base/layout.h"

namespace kerf {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kPictures = 65;  // of four steps each: then the halves lie on the floor

/// One look of the window.
struct Look {
    ui::Theme theme = ui::Theme::dark;
    int scale = 1;
    std::string name() const {
        return std::string(theme == ui::Theme::dark ? "dark" : "light") + "-" +
               std::to_string(scale) + "x";
    }
};

class Photographer {
  public:
    Photographer(const Look& look, ui::Settings settings, std::filesystem::path folder,
                 app::Document document)
        : look_(look), settings_(std::move(settings)), folder_(std::move(folder)) {
        settings_.theme = look.theme;
        const std::filesystem::path file = folder_ / "settings.json";
        app::writeOutputFile(file, app::formatSettings(settings_));
        app::EditorOptions options;
        options.width = kWidth * look.scale;
        options.height = kHeight * look.scale;
        options.scale = static_cast<float>(look.scale);
        options.device = gpu::queryDevice().renderer.substr(0, 8);
        options.byTheClock = false;
        options.quality = look.scale == 1 ? render::Quality::full : render::Quality::light;
        options.settingsFile = file;
        editor_ = std::make_unique<app::Editor>(options, std::move(document));
        std::filesystem::remove(file);
        frames(3);
    }

    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            editor_->frame(watch_.restart());
        }
    }
    /// The session from its start until the halves lie on the floor.
    void play() {
        tap(ui::Key::equal);
        tap(ui::Key::equal);
        tap(ui::Key::space);
        frames(kPictures);
        tap(ui::Key::space);
    }
    void tap(ui::Key key, const ui::Modifiers& modifiers = {}) {
        editor_->post(ui::KeyChange{key, true, modifiers});
        editor_->post(ui::KeyChange{key, false, modifiers});
        frames(3);
    }
    void settle() {
        for (int i = 0; i < 400 && editor_->idleSeconds() == 0; ++i) {
            frames(1);
        }
    }
    /// Across the view; places as shares of it.
    void drag(const Vec2& from, const Vec2& to) {
        const ui::Rect view = layout().view;
        for (int i = 0; i <= 20; ++i) {
            const Vec2 at = from + (to - from) * i / 20.0;
            editor_->post(
                ui::PointerMove{view.x + at.x() * view.width, view.y + at.y() * view.height, {}});
            if (i == 0) {
                editor_->post(ui::ButtonChange{ui::Button::left, true, {}});
            }
        }
        editor_->post(ui::ButtonChange{ui::Button::left, false, {}});
        settle();
    }
    /// A file that is waited for.
    void open(const std::filesystem::path& file) {
        editor_->open(file);
        do {
            frames(1);
        } while (editor_->working());
        frames(3);
    }
    void moveOnto(const std::string& item, double shareX = 0.5, double shareY = 0.5) {
        const ui::Rect place = editor_->itemRects().at(item);
        editor_->post(
            ui::PointerMove{place.x + shareX * place.width, place.y + shareY * place.height, {}});
        frames(3);
    }
    void click(const std::string& item) {
        moveOnto(item);
        editor_->post(ui::ButtonChange{ui::Button::left, true, {}});
        editor_->post(ui::ButtonChange{ui::Button::left, false, {}});
        frames(3);
    }
    void moveAway() {
        editor_->post(ui::PointerMove{0.5 * kWidth * look_.scale, 4, {}});
        frames(3);
    }

    void takeWindow(const std::string& name) { write(name, editor_->readPicture()); }
    void takeControls(const std::string& name) { write(name, crop(layout().controls)); }
    void takeReadings(const std::string& name) { write(name, crop(layout().plots)); }

  private:
    ui::Layout layout() const {
        return ui::layoutPanels(static_cast<float>(kWidth * look_.scale),
                                static_cast<float>(kHeight * look_.scale),
                                static_cast<float>(look_.scale), settings_);
    }
    render::Image crop(const ui::Rect& rect) const {
        const render::Image whole = editor_->readPicture();
        render::Image part{static_cast<int>(rect.width), static_cast<int>(rect.height), {}};
        for (int y = 0; y < part.height; ++y) {
            const auto row =
                whole.pixels.begin() +
                4 * ((y + static_cast<int>(rect.y)) * whole.width + static_cast<int>(rect.x));
            part.pixels.insert(part.pixels.end(), row, row + 4 * part.width);
        }
        return part;
    }
    void write(const std::string& name, const render::Image& picture) const {
        const std::filesystem::path file = folder_ / (name + "-" + look_.name() + ".png");
        app::writePicture(picture, file);
        std::printf("%s\n", file.c_str());
    }

    Look look_;
    ui::Settings settings_;
    std::filesystem::path folder_;
    std::unique_ptr<app::Editor> editor_;
    Stopwatch watch_;
};

app::Document experiment() {
    return app::openDocument(gpu::dataPath("assets/sessions/sphere768.kerf.json"));
}

void takeAll(const Look& look, const std::filesystem::path& folder) {
    Photographer window(look, {}, folder, experiment());
    window.takeWindow("start");
    window.play();
    window.moveAway();
    window.takeWindow("window");
    window.takeControls("controls");
    window.takeReadings("times");
    window.click("tab.History");
    window.moveAway();
    window.takeReadings("history");
    window.click("tab.Log");
    window.moveAway();
    window.takeReadings("log");
    window.moveOnto("plot.volume", 0.6, 0.4);
    window.takeReadings("crosshair");
    window.moveOnto("piece.1", 0.6);
    window.takeWindow("piece");
    window.moveOnto("param.time_step");
    window.takeWindow("tooltip");
    window.click("section.tools");
    window.click("section.experiments");
    window.moveAway();
    window.takeControls("experiments");
}

void takePlots(const Look& look, const std::filesystem::path& folder) {
    ui::Settings settings;
    settings.plots = {"frames", "times", "volume", "pieces", "energy", "touched"};
    settings.readingsWidth = 420;
    settings.plotsShare = 1;
    settings.folded = {"experiments", "tools", "display", "window"};
    Photographer window(look, settings, folder, experiment());
    window.play();
    window.click("plots.choose");
    window.takeWindow("plots");
}

/// What a newcomer sees first.
void takeFirstMinute(const Look& look, const std::filesystem::path& folder) {
    Photographer window(look, {}, folder, app::openDocument(app::startSession("citrus")));
    window.takeWindow("first");
    window.drag({0.5, 0.4}, {0.5, 0.6});
    window.takeWindow("incision");
    window.tap(ui::Key::z, {.control = true});
    window.drag({0.05, 0.35}, {0.95, 0.6});
    window.takeWindow("cut");
    window.tap(ui::Key::a);
    window.takeWindow("apart");
    window.tap(ui::Key::space, {.shift = true});
    window.frames(kPictures);
    window.tap(ui::Key::space);
    window.takeWindow("fallen");
}

/// What is seldom open: dialogs, and the rows of each tool.
void takeDialogs(const Look& look, const std::filesystem::path& folder) {
    ui::Settings settings;
    settings.folded = {"experiments", "simulation"};
    Photographer window(look, settings, folder, app::openDocument(app::startSession("citrus")));
    window.takeControls("display");
    window.tap(ui::Key::g);
    window.takeWindow("guillotine");
    window.tap(ui::Key::p);
    window.takeControls("pin");
    window.click("tab.Boxes");
    window.click("boxes.add");
    window.click("box.0");
    window.moveAway();
    window.takeReadings("boxes");
    window.tap(ui::Key::f1);
    window.takeWindow("help");
    window.tap(ui::Key::f1);
    window.tap(ui::Key::o, {.control = true});
    window.takeWindow("open");
    window.tap(ui::Key::escape);
    window.tap(ui::Key::e, {.control = true});
    window.takeWindow("export");
    window.tap(ui::Key::escape);
    const std::filesystem::path file = folder / "open-box.obj";
    app::writeOutputFile(file,
                         "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1 0\n"
                         "f 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n");
    window.open(file);
    std::filesystem::remove(file);
    window.takeWindow("question");
}

void run(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const gpu::EglContext context;
    for (const Look& look : {Look{ui::Theme::dark, 1}, Look{ui::Theme::light, 1},
                             Look{ui::Theme::dark, 2}, Look{ui::Theme::light, 2}}) {
        takeAll(look, folder);
        takePlots(look, folder);
        takeFirstMinute(look, folder);
        takeDialogs(look, folder);
    }
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: kerf_pictures DIR\n");
        return 2;
    }
    try {
        kerf::run(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kerf_pictures: %s\n", error.what());
        return 1;
    }
}
