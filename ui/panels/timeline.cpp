#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

constexpr float kStripHeight = 0.75F;  // of a line
constexpr float kMarkSize = 0.27F;     // half of it, of a line
constexpr std::size_t kMostListed = 8;
constexpr int kFarStep = 10;  // steps, by an arrow key with Shift

/// The steps along a slider, as its knob stands at them.
class StepScale {
  public:
    /// Of the slider that was drawn last.
    explicit StepScale(int steps) : steps_(static_cast<float>(std::max(1, steps))) {
        constexpr float kInset = 2;  // ImGui's, of the knob
        const float width = ImGui::GetItemRectSize().x - 2 * kInset;
        const float knob = std::min(ImGui::GetStyle().GrabMinSize, width);
        left_ = ImGui::GetItemRectMin().x + kInset + knob / 2;
        width_ = width - knob;
    }
    float xOf(int step) const {
        return std::floor(left_ + width_ * static_cast<float>(step) / steps_) + 0.5F;
    }
    /// Where a row of this width begins that stands about a step, as far as there is room.
    float startOf(int step, float width) const {
        return std::max(left_, std::min(xOf(step) - width / 2, left_ + width_ - width));
    }

  private:
    float steps_;
    float left_;
    float width_;
};

/// A red mark on the item above, where the replay first came out differently.
void markDivergence(const PlaybackState& playback, const StepScale& scale) {
    if (!playback.divergedAt) {
        return;
    }
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float x = scale.xOf(*playback.divergedAt);
    const float half = 0.12F * (high.y - low.y);
    ImGui::GetWindowDrawList()->AddRectFilled({x - half, low.y}, {x + half, high.y},
                                              IM_COL32(235, 52, 43, 255));
}

/// Above the time line, which it would cover otherwise.
void tellAbove(const std::string& text) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const float top = ImGui::GetWindowPos().y - 0.4F * ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize(text.c_str()).x + 4 * ImGui::GetFontSize();
    const float right = ImGui::GetIO().DisplaySize.x - width / 2;
    ImGui::SetNextWindowPos({std::clamp(pointer.x, width / 2, std::max(width / 2, right)), top},
                            ImGuiCond_Always, {0.5F, 1});
    ImGui::SetTooltip("%s", text.c_str());
}

ImU32 colorOfTick(SessionMark::Kind kind) {
    switch (kind) {
        case SessionMark::Kind::stroke:
            return palette().of(Hue::vermillion);
        case SessionMark::Kind::tear:
            return palette().of(Hue::orange);
        case SessionMark::Kind::hand:
            return palette().of(Hue::cyan);
        case SessionMark::Kind::scene:
            return palette().of(Hue::yellow);
        default:
            return palette().of(Hue::purple);
    }
}

bool isCut(SessionMark::Kind kind) {
    return kind == SessionMark::Kind::stroke || kind == SessionMark::Kind::tear;
}

/// Through the groove: cuts and tears all the way, all else in its lower half.
void drawTicks(const std::vector<SessionMark>& course, const StepScale& scale) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float half = std::max(1.0F, ImGui::GetFontSize() / 15);
    for (const SessionMark& mark : course) {
        const float x = scale.xOf(mark.step);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {x - half, isCut(mark.kind) ? low.y : (low.y + high.y) / 2}, {x + half, high.y},
            colorOfTick(mark.kind));
    }
}

/// What was done at the pointer, the first ones of much; "" where nothing was.
std::string pastAt(float x, const std::vector<SessionMark>& course, const StepScale& scale) {
    std::string text;
    std::size_t listed = 0;
    for (const SessionMark& mark : course) {
        if (std::abs(scale.xOf(mark.step) - x) <= 0.3F * ImGui::GetFontSize() &&
            listed++ < kMostListed) {
            text += labelOf(mark) + ", step " + std::to_string(mark.step) + "\n";
        }
    }
    return text;
}

/// The number stands beside it. A slider of whole numbers would have a knob as wide as few steps.
bool slideStep(int& step, int steps) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const int before = step;
    auto at = static_cast<float>(step);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{0, 0, 0, 0});
    ImGui::SliderFloat("##scrub", &at, 0, static_cast<float>(std::max(1, steps)), "%.0f",
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    step = static_cast<int>(std::lround(at));
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return step != before;
}

/// Where a key leads while the pointer is over the time line.
std::optional<int> stepOfKeys(const PlaybackState& playback) {
    const auto pressed = [](ImGuiKey key) { return keyPressed(key, true); };
    if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
        return std::nullopt;
    }
    if (pressed(ImGuiKey_Home) || pressed(ImGuiKey_End)) {
        return pressed(ImGuiKey_Home) ? 0 : playback.steps;
    }
    const int way = (pressed(ImGuiKey_RightArrow) ? 1 : 0) - (pressed(ImGuiKey_LeftArrow) ? 1 : 0);
    const int far = ImGui::GetIO().KeyShift ? kFarStep : 1;
    return way == 0 ? std::nullopt
                    : std::optional(std::clamp(playback.step + way * far, 0, playback.steps));
}

const char* adviceOn(const PlaybackState& playback) {
    if (!playback.goesBack) {
        return "Your actions are recorded here, so that you can go back";
    }
    if (playback.divergedAt) {
        return "Go to a step, also by Home, End and arrow keys. Red: the replay differs from the "
               "recording";
    }
    return playback.played ? "Go to a step, also by Home, End and arrow keys"
                           : "Go back to a step and continue from there";
}

StepScale drawSlider(const SessionPanelState& session, std::vector<Action>& actions) {
    const PlaybackState& playback = session.playback;
    int step = std::min(playback.step, playback.steps);
    ImGui::SetNextItemWidth(-1);
    ImGui::BeginDisabled(!playback.goesBack || playback.steps == 0);
    const std::optional<int> byKey = playback.goesBack ? stepOfKeys(playback) : std::nullopt;
    if (slideStep(step, playback.steps) || byKey) {
        actions.emplace_back(SeekTo{byKey.value_or(step)});
    }
    ImGui::EndDisabled();
    noteItem("scrubber");
    const StepScale scale(playback.steps);
    drawTicks(session.past, scale);
    markDivergence(playback, scale);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive()) {
        tellAbove(pastAt(ImGui::GetIO().MousePos.x, session.past, scale) + adviceOn(playback));
    }
    return scale;
}

ImU32 colorOf(SessionMark::Kind kind) {
    switch (kind) {
        case SessionMark::Kind::picture:
            return palette().of(Hue::cyan);
        case SessionMark::Kind::exported:
            return palette().of(Hue::orange);
        case SessionMark::Kind::camera:
            return palette().of(Hue::yellow);
        case SessionMark::Kind::name:
            return palette().of(Hue::purple);
        default:
            break;
    }
    return palette().of(Hue::green);
}

/// A triangle for a picture, a square for an export, a diamond for a camera, a flag for a name, a
/// disc for a check.
void drawMark(SessionMark::Kind kind, const ImVec2& center, float size) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = colorOf(kind);
    const auto& [x, y] = center;
    switch (kind) {
        case SessionMark::Kind::picture:
            draw.AddTriangleFilled({x, y - size}, {x + size, y + size}, {x - size, y + size},
                                   color);
            return;
        case SessionMark::Kind::exported:
            draw.AddRectFilled({x - size, y - size}, {x + size, y + size}, color);
            return;
        case SessionMark::Kind::camera:
            draw.AddQuadFilled({x, y - size}, {x + size, y}, {x, y + size}, {x - size, y}, color);
            return;
        case SessionMark::Kind::name:
            draw.AddTriangleFilled({x - size, y - size}, {x + size, y}, {x - size, y + size},
                                   color);
            return;
        default:
            draw.AddCircleFilled(center, size, color);
            return;
    }
}

/// A mark where it is drawn.
struct PlacedMark {
    const SessionMark* mark = nullptr;
    float x = 0;  ///< of its middle [px]
};

float markSize() {
    return kMarkSize * ImGui::GetFontSize();
}

/// Those of one step stand side by side.
std::vector<PlacedMark> placed(const std::vector<SessionMark>& marks, const StepScale& scale) {
    const float apart = 2.4F * markSize();
    std::vector<PlacedMark> all;
    for (auto first = marks.begin(); first != marks.end();) {
        const auto isOther = [&](const SessionMark& mark) { return mark.step != first->step; };
        const auto end = std::find_if(first, marks.end(), isOther);
        float x = scale.startOf(first->step, apart * static_cast<float>(end - first - 1));
        for (; first != end; ++first, x += apart) {
            all.push_back({&*first, x});
        }
    }
    return all;
}

/// The marks that a pointer at `x` points at, the first ones of many.
std::vector<const SessionMark*> marksAt(float x, const std::vector<PlacedMark>& marks) {
    std::vector<const SessionMark*> found;
    for (const PlacedMark& place : marks) {
        if (std::abs(place.x - x) <= 1.2F * markSize() && found.size() < kMostListed) {
            found.push_back(place.mark);
        }
    }
    return found;
}

std::string withStep(const SessionMark& mark) {
    return labelOf(mark) + ", step " + std::to_string(mark.step);
}

void tellOf(const std::vector<const SessionMark*>& marks) {
    std::string text;
    for (const SessionMark* mark : marks) {
        text += withStep(*mark) + "\n";
    }
    if (ImGui::IsItemHovered()) {
        tellAbove(text + "Click: go there. Right-click: remove");
    }
}

/// What a right click offers, where the pointer was then.
void drawRemovals(const std::vector<PlacedMark>& marks, std::vector<Action>& actions) {
    const ImGuiID place = ImGui::GetID("right click");
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        storage.SetFloat(place, ImGui::GetIO().MousePos.x);
        ImGui::OpenPopup("marks");
    }
    const std::vector<const SessionMark*> found = marksAt(storage.GetFloat(place), marks);
    if (found.empty() || !ImGui::BeginPopup("marks")) {
        return;
    }
    for (const SessionMark* mark : found) {
        ImGui::PushID(mark->id);
        if (ImGui::MenuItem(("Remove: " + withStep(*mark)).c_str())) {
            actions.emplace_back(RemoveMark{mark->id});
        }
        noteItem("mark.remove." + std::to_string(mark->step));
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

void drawMarks(const SessionPanelState& session, const Rect& strip, const StepScale& scale,
               std::vector<Action>& actions) {
    ImGui::SetCursorScreenPos({strip.x, strip.y});
    ImGui::InvisibleButton("##marks", {strip.width, strip.height},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    noteItem("timeline.marks");
    const std::vector<PlacedMark> marks = placed(session.marks, scale);
    for (const PlacedMark& place : marks) {
        drawMark(place.mark->kind, {place.x, strip.y + strip.height / 2}, markSize());
    }
    const auto under = marksAt(ImGui::GetIO().MousePos.x, marks);
    if (!under.empty()) {
        tellOf(under);
    }
    if (!under.empty() && ImGui::IsItemClicked()) {
        actions.emplace_back(SeekTo{under.front()->step});
    }
    drawRemovals(marks, actions);
}

void beginStrip(const Rect& rect) {
    const float padding = 0.6F * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, 0.2F * padding});
    ImGui::Begin("timeline", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(3);
}

/// The step, in front of slider and marks. Returns where those begin.
float drawStep(const PlaybackState& playback) {
    const std::string steps = std::to_string(playback.steps);
    const float widest = ImGui::CalcTextSize(("step " + steps + " of " + steps).c_str()).x;
    const float height = ImGui::GetContentRegionAvail().y;
    ImGui::SetCursorPosY((height - ImGui::GetFontSize()) / 2);
    ImGui::Text("step %d of %d", std::min(playback.step, playback.steps), playback.steps);
    return ImGui::GetCursorPosX() + widest + 0.8F * ImGui::GetFontSize();
}

}  // namespace

std::string labelOf(const SessionMark& mark) {
    switch (mark.kind) {
        case SessionMark::Kind::picture:
            return "Picture " + mark.text;
        case SessionMark::Kind::exported:
            return "Export " + mark.text;
        case SessionMark::Kind::camera:
            return "Camera keyframe";
        case SessionMark::Kind::check:
            return "Check: " + mark.text;
        default:
            return mark.text;
    }
}

void drawTimeline(const SessionPanelState& session, const Rect& rect,
                  std::vector<Action>& actions) {
    beginStrip(rect);
    const float left = drawStep(session.playback);
    const float height = kStripHeight * ImGui::GetFontSize();
    const float gap = (rect.height - height - ImGui::GetFontSize()) / 3;
    ImGui::SetCursorPos({left, 2 * gap + height});
    const StepScale scale = drawSlider(session, actions);
    const Rect strip{ImGui::GetItemRectMin().x, rect.y + gap, ImGui::GetItemRectSize().x, height};
    drawMarks(session, strip, scale, actions);
    ImGui::End();
}

}  // namespace kerf::ui
