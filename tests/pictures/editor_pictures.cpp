// Pictures of the editor, to look at and for the README: the whole window and each panel, at both
// scales and in both themes. Usage: kerf_pictures DIR
// Or a film of a task that is practised, DIR/practice.gif: kerf_pictures --practice DIR
#include <cstdio>

#include "app/editor/editor.h"
#include "app/editor/storage/settings_file.h"
#include "app/editor/view/editor_panels.h"
#include "app/files/film/film_encoder.h"
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
    int width = kWidth;  ///< at scale 1
    int height = kHeight;
    std::string name() const {
        return std::string(theme == ui::Theme::dark ? "dark" : "light") + "-" +
               std::to_string(scale) + "x";
    }
};

class Photographer {
  public:
    Photographer(const Look& look, ui::Settings settings, std::filesystem::path folder,
                 std::optional<app::Document> document = std::nullopt)
        : look_(look), settings_(std::move(settings)), folder_(std::move(folder)) {
        settings_.theme = look.theme;
        const std::filesystem::path file = folder_ / "settings.json";
        app::writeOutputFile(file, app::formatSettings(settings_));
        app::EditorOptions options;
        options.width = look.width * look.scale;
        options.height = look.height * look.scale;
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
    /// Instead of dragging a slider.
    void type(const std::string& slider, const std::string& text) {
        click(slider + ".number");
        for (const char letter : text) {
            editor_->post(ui::Character{static_cast<std::uint32_t>(letter)});
        }
        frames(3);
        tap(ui::Key::enter);
    }
    void moveAway() {
        editor_->post(ui::PointerMove{0.5 * look_.width * look_.scale, 4, {}});
        frames(3);
    }

    app::Editor& editor() { return *editor_; }
    void takeWindow(const std::string& name) { write(name, editor_->readPicture()); }
    void takeControls(const std::string& name) { write(name, crop(layout().controls)); }
    void takeReadings(const std::string& name) { write(name, crop(layout().plots)); }

  private:
    ui::Layout layout() const {
        return ui::layoutPanels(static_cast<float>(look_.width * look_.scale),
                                static_cast<float>(look_.height * look_.scale),
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

/// A window in which a hand does the incision to practise. A picture of it takes one step.
class PracticeFilm {
  public:
    explicit PracticeFilm(const std::filesystem::path& folder)
        : window_({.width = 960, .height = 600}, settings(), folder),
          film_(folder / "practice.gif", folder / "practice.unfinished", 960, 600, kRate) {}

    void make() {
        prepare();
        const std::vector<Vec2> line = lineShown();
        const auto lead = [&](double share) {
            const Vec2 at = line.front() + share * (line.back() - line.front());
            window_.editor().post(ui::PointerMove{at.x(), at.y(), {}});
        };
        lead(0);
        hold(1);
        window_.editor().post(ui::ButtonChange{ui::Button::left, true, {}});
        for (double time = 0; time < kSeconds; time += kStep) {
            const double t = time / kSeconds;
            lead(t * t * t * (10 - 15 * t + 6 * t * t));  // least jerk
            hold(kStep);
        }
        window_.editor().post(ui::ButtonChange{ui::Button::left, false, {}});
        do {
            hold(kStep);
        } while (window_.editor().idleSeconds() == 0);
        window_.moveAway();
        hold(0.6);
        window_.tap(ui::Key::enter, {.shift = true});
        window_.frames(3);
        const render::Image score = window_.editor().readPicture();
        for (int i = 0; i < 4 * kRate; ++i) {
            film_.add(score);
        }
        film_.finish();
    }

  private:
    static constexpr double kStep = 0.02;  // of the task [s]
    static constexpr int kEach = 4;        // of the pictures is in the film
    static constexpr int kRate = 12;       // pictures a second of the film: about as fast
    static constexpr double kSeconds = 4;  // of the cut

    static ui::Settings settings() {
        ui::Settings settings;
        settings.showReadings = false;
        settings.showExpert = false;  // It goes by the clock, which a film doesn't.
        settings.controlsWidth = 330;
        settings.piecesShare = 0;
        return settings;
    }
    void prepare() {
        window_.open(gpu::dataPath("assets/practice/incision.kerf.json"));
        window_.settle();
        window_.moveAway();
    }
    std::vector<Vec2> lineShown() {
        std::vector<Vec2> points;
        for (const ui::Overlay::Trace& trace : window_.editor().panels().view.overlay.traces) {
            for (const ui::PlotPoint& point : trace.line) {
                if (trace.kind == ui::Overlay::Trace::Kind::line)
                    points.emplace_back(point.x, point.y);
            }
        }
        return points;
    }
    void hold(double seconds) {
        for (double time = 0; time < seconds - kStep / 2; time += kStep) {
            window_.editor().frame(kStep);
            if (taken_++ % kEach == 0) film_.add(window_.editor().readPicture());
        }
    }

    Photographer window_;
    app::FilmEncoder film_;
    int taken_ = 0;
};

void run(const std::filesystem::path& folder) {
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
    const bool films = argc == 3 && std::string(argv[1]) == "--practice";
    if (argc != 2 && !films) {
        std::fprintf(stderr, "usage: kerf_pictures [--practice] DIR\n");
        return 2;
    }
    try {
        std::filesystem::create_directories(argv[argc - 1]);
        const kerf::gpu::EglContext context;
        if (films) {
            kerf::PracticeFilm(argv[2]).make();
        } else {
            kerf::run(argv[1]);
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kerf_pictures: %s\n", error.what());
        return 1;
    }
}
