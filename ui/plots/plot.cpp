#include "ui/plots/plot.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/base/layout.h"

namespace kerf::ui {
namespace {

/// The frame of a plot: maps its data to pixels.
struct PlotFrame {
    ImVec2 low;   ///< top left corner
    ImVec2 high;  ///< bottom right corner
    PlotRange x;
    PlotRange y;

    float atX(double value) const {
        return low.x + (high.x - low.x) * static_cast<float>((value - x.low) / x.span());
    }
    float atY(double value) const {
        return high.y - (high.y - low.y) * static_cast<float>((value - y.low) / y.span());
    }
    double timeAt(float pixel) const { return x.low + (pixel - low.x) / width() * x.span(); }
    float width() const { return std::max(1.0F, high.x - low.x); }
    int columns() const { return static_cast<int>(width()); }
    bool holds(const ImVec2& p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
    }
};

unsigned colorOf(const PlotCurve& curve) {
    return curve.color != 0 ? curve.color : palette().of(curve.hue);
}

/// A dash and the gap after it [px]; a gap of 0 for a solid line.
struct Dashes {
    float on = 1;
    float off = 0;
};

Dashes dashesOf(CurveStyle style) {
    const float unit = ImGui::GetFontSize() / 15;
    switch (style) {
        case CurveStyle::dashed:
            return {6 * unit, 3 * unit};
        case CurveStyle::dotted:
            return {2 * unit, 2 * unit};
        case CurveStyle::solid:
            break;
    }
    return {};
}

/// The parts of a segment that fall onto dashes. They stand at fixed x, so that a curve that moves
/// does not flicker.
void drawDashed(ImDrawList& draw, const ImVec2& from, const ImVec2& to, unsigned color,
                float thickness, const Dashes& dashes) {
    if (dashes.off == 0 || to.x <= from.x) {
        draw.AddLine(from, to, color, thickness);
        return;
    }
    const float period = dashes.on + dashes.off;
    const float slope = (to.y - from.y) / (to.x - from.x);
    for (float start = std::floor(from.x / period) * period; start < to.x; start += period) {
        const float begin = std::max(from.x, start);
        const float end = std::min(to.x, start + dashes.on);
        if (end > begin) {
            draw.AddLine({begin, from.y + slope * (begin - from.x)},
                         {end, from.y + slope * (end - from.x)}, color, thickness);
        }
    }
}

float curveThickness() {
    return ImGui::GetFontSize() / 10;
}

// --- Around the frame --------------------------------------------------------------------------

void drawLastValue(const PlotSpec& spec) {
    const PlotCurve& curve = spec.curves.front();
    if (curve.series->empty()) {
        return;
    }
    const std::string value = numberText(curve.series->last(), spec.readoutDecimals);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
    ImGui::TextUnformatted(value.c_str());
}

/// The labels of a legend, from the left to the right and then in the next line.
class LegendFlow {
  public:
    LegendFlow() : corner_(ImGui::GetCursorScreenPos()), at_(corner_) {}

    /// Where something of that width goes; false where even the last line has no room.
    bool place(float width) {
        const float end = corner_.x + ImGui::GetContentRegionAvail().x;
        if (at_.x > corner_.x && at_.x + width > end) {
            at_ = {corner_.x, at_.y + ImGui::GetTextLineHeight()};
            ++lines_;
        }
        return lines_ <= kMostLines;
    }
    const ImVec2& at() const { return at_; }
    void advance(float width) { at_.x += width + 0.8F * ImGui::GetFontSize(); }
    float height() const {
        return static_cast<float>(std::min(lines_, kMostLines)) * ImGui::GetTextLineHeight();
    }

  private:
    static constexpr int kMostLines = 3;

    ImVec2 corner_;
    ImVec2 at_;
    int lines_ = 1;
};

/// A sample of each line with its label, in as many lines as that needs; dots for what is left out.
void drawLegend(const PlotSpec& spec) {
    const float line = ImGui::GetFontSize();
    const float sample = 1.4F * line;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    LegendFlow flow;
    for (const PlotCurve& curve : spec.curves) {
        const float width = sample + 0.3F * line + ImGui::CalcTextSize(curve.label.c_str()).x;
        const ImVec2 before = flow.at();
        if (!flow.place(width)) {
            draw.AddText(before, palette().dimText, "\u2026");
            break;
        }
        const auto& [x, y] = flow.at();
        const float middle = std::round(y + 0.55F * line);
        drawDashed(draw, {x, middle}, {x + sample, middle}, colorOf(curve), 1.3F * curveThickness(),
                   dashesOf(curve.style));
        draw.AddText({x + sample + 0.3F * line, y}, palette().dimText, curve.label.c_str());
        flow.advance(width);
    }
    ImGui::Dummy({1, flow.height()});
}

/// A dim line that ends with dots where it is too long.
void drawNote(const std::string& note) {
    const float line = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float end = corner.x + ImGui::GetContentRegionAvail().x;
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dimText);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), corner, {end, corner.y + line}, end, end,
                              note.data(), note.data() + note.size(), nullptr);
    ImGui::PopStyleColor();
    ImGui::Dummy({1, line});
}

void drawHeader(const PlotSpec& spec) {
    ImGui::TextUnformatted(spec.title.data(), spec.title.data() + spec.title.size());
    if (spec.curves.size() == 1) {
        drawLastValue(spec);
    } else {
        drawLegend(spec);
    }
    for (const std::string& note : spec.notes) {
        drawNote(note);
    }
}

PlotTicks ticksY(const PlotRange& range, float height) {
    return niceTicks(range, std::max(2, static_cast<int>(height / (1.5F * ImGui::GetFontSize()))));
}

void drawTicksY(ImDrawList& draw, const PlotFrame& frame) {
    const float line = ImGui::GetFontSize();
    const PlotTicks ticks = ticksY(frame.y, frame.high.y - frame.low.y);
    for (const double value : ticks.values) {
        const float y = std::round(frame.atY(value));
        const std::string text = numberText(value, ticks.decimals);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float top = std::clamp(y - line / 2, frame.low.y - line / 4, frame.high.y - line);
        draw.AddLine({frame.low.x, y}, {frame.high.x, y}, palette().grid);
        draw.AddText({frame.low.x - width - 0.4F * line, top}, palette().dimText, text.c_str());
    }
}

void drawTicksX(ImDrawList& draw, const PlotFrame& frame, std::string_view unit) {
    const float line = ImGui::GetFontSize();
    const int most = std::max(2, static_cast<int>(frame.width() / (2.4F * line)));
    const PlotTicks ticks = niceTicks(frame.x, most);
    float freeUntil = frame.high.x;
    for (auto tick = ticks.values.rbegin(); tick != ticks.values.rend(); ++tick) {
        const float x = std::round(frame.atX(*tick));
        std::string text = fixedText(*tick, ticks.decimals);
        if (tick == ticks.values.rbegin()) {
            text += " " + std::string(unit);
        }
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float left = std::min(x - width / 2, frame.high.x - width);
        draw.AddLine({x, frame.low.y}, {x, frame.high.y}, palette().grid);
        if (left + width <= freeUntil) {
            draw.AddText({left, frame.high.y + 0.2F * line}, palette().dimText, text.c_str());
            freeUntil = left - 0.3F * line;
        }
    }
}

// --- Inside the frame --------------------------------------------------------------------------

void drawMarks(ImDrawList& draw, const PlotFrame& frame, std::span<const PlotMark> marks) {
    float freeFrom = frame.low.x;
    for (const PlotMark& mark : marks) {
        if (mark.x < frame.x.low || mark.x > frame.x.high) {
            continue;
        }
        const float x = std::round(frame.atX(mark.x));
        draw.AddLine({x, frame.low.y}, {x, frame.high.y}, palette().mark);
        const float width = ImGui::CalcTextSize(mark.label.c_str()).x;
        // Right of its line, or left of it at the plot's end; left out where it would run into
        // another.
        const float left = x + width + 6 < frame.high.x ? x + 3 : x - width - 3;
        if (left >= freeFrom) {
            draw.AddText({left, frame.low.y + 1}, palette().dimText, mark.label.c_str());
            freeFrom = left + width + 5;
        }
    }
}

/// The label stands at the lower end of the plot's right side, where marks have none.
void drawReference(ImDrawList& draw, const PlotFrame& frame, const PlotReference& reference) {
    const float line = ImGui::GetFontSize();
    const bool above = reference.value > frame.y.high;
    const bool below = reference.value < frame.y.low;
    const std::string text = above   ? reference.label + " \u2191"
                             : below ? reference.label + " \u2193"
                                     : reference.label;
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float y = std::round(frame.atY(reference.value));
    float top = y + 1;
    if (above) {
        top = frame.low.y + 1.1F * line;  // below the labels of marks
    } else if (below || top + line > frame.high.y) {
        top = below ? frame.high.y - 1.1F * line : y - 1.1F * line;
    }
    if (!above && !below) {
        const float unit = line / 15;
        drawDashed(draw, {frame.low.x, y}, {frame.high.x, y}, palette().mark, std::max(1.0F, unit),
                   {5 * unit, 4 * unit});
    }
    // Curves and marks may pass here.
    const float left = frame.high.x - width - 0.3F * line;
    draw.AddRectFilled({left - 0.2F * line, top}, {frame.high.x, top + line}, palette().plotGround);
    draw.AddText({left, top}, palette().dimText, text.c_str());
}

void drawCurve(ImDrawList& draw, const PlotFrame& frame, const PlotCurve& curve) {
    const std::vector<PlotColumn> columns =
        gatherColumns(curve.series->buckets(), frame.x, frame.columns());
    const unsigned color = colorOf(curve);
    const ImU32 band = (color & ~IM_COL32_A_MASK) | (72U << IM_COL32_A_SHIFT);
    const double pixel = frame.x.span() / frame.columns();
    std::vector<ImVec2> line;
    line.reserve(columns.size());
    for (const PlotColumn& column : columns) {
        const float x = frame.atX(frame.x.low + (column.column + 0.5) * pixel);
        const float top = frame.atY(column.high);
        const float bottom = frame.atY(column.low);
        if (bottom - top > 1) {
            draw.AddRectFilled({x - 0.5F, top}, {x + 0.5F, bottom}, band);
        }
        line.push_back({x, frame.atY(column.mean)});
    }
    const float thickness = curveThickness();
    const Dashes dashes = dashesOf(curve.style);
    // Segment by segment: ImGui's polyline thins out where a curve turns sharply.
    for (std::size_t i = 1; i < line.size(); ++i) {
        drawDashed(draw, line[i - 1], line[i], color, thickness, dashes);
    }
    if (line.size() == 1) {
        draw.AddCircleFilled(line.front(), thickness, color);
    }
}

/// "98.21", or "97.90 to 98.40" where a bucket holds more than one value.
std::string readout(const SeriesBucket& bucket, int decimals) {
    const std::string low = numberText(bucket.low, decimals);
    const std::string high = numberText(bucket.high, decimals);
    return low == high ? low : low + " to " + high;
}

void drawTooltip(const PlotSpec& spec, double time) {
    ImGui::BeginTooltip();
    ImGui::TextDisabled("%s %s", fixedText(time, 3).c_str(), std::string(spec.xUnit).c_str());
    for (const PlotCurve& curve : spec.curves) {
        if (!curve.series->empty()) {
            const SeriesBucket& bucket = nearestBucket(curve.series->buckets(), time);
            ImGui::Text("%s %s", curve.label.c_str(),
                        readout(bucket, spec.readoutDecimals).c_str());
        }
    }
    ImGui::EndTooltip();
}

/// The time of the value nearest to the pointer; none where there are no values, or the pointer is
/// beside the plot.
std::optional<double> timeUnderPointer(const PlotFrame& frame, const PlotSpec& spec) {
    const float x = ImGui::GetMousePos().x;
    const auto curve =
        std::ranges::find_if(spec.curves, [](const PlotCurve& c) { return !c.series->empty(); });
    if (curve == spec.curves.end() || x < frame.low.x || x > frame.high.x) {
        return std::nullopt;
    }
    return nearestBucket(curve->series->buckets(), frame.timeAt(x)).x;
}

/// A line at a time, with a dot on each curve.
void drawCrosshair(ImDrawList& draw, const PlotFrame& frame, const PlotSpec& spec, double time) {
    const float x = std::clamp(frame.atX(time), frame.low.x, frame.high.x);
    draw.AddLine({x, frame.low.y}, {x, frame.high.y}, palette().frame);
    for (const PlotCurve& curve : spec.curves) {
        if (!curve.series->empty()) {
            const SeriesBucket& bucket = nearestBucket(curve.series->buckets(), time);
            const float y = std::clamp(frame.atY(bucket.mean), frame.low.y, frame.high.y);
            draw.AddCircleFilled({x, y}, ImGui::GetFontSize() / 5, colorOf(curve));
        }
    }
}

/// The values at a time beside the line there, in the colours of their curves.
void drawValues(ImDrawList& draw, const PlotFrame& frame, const PlotSpec& spec, double time) {
    const float line = ImGui::GetFontSize();
    const float x = std::clamp(frame.atX(time), frame.low.x, frame.high.x);
    float top = frame.low.y + 1;
    for (const PlotCurve& curve : spec.curves) {
        if (curve.series->empty() || top + line > frame.high.y) {
            continue;
        }
        const SeriesBucket& bucket = nearestBucket(curve.series->buckets(), time);
        const std::string text = readout(bucket, spec.readoutDecimals);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const bool right = x + width + 0.6F * line < frame.high.x;
        const float left = right ? x + 0.4F * line : x - width - 0.4F * line;
        draw.AddRectFilled({left - 2, top}, {left + width + 2, top + line}, palette().plotGround);
        draw.AddText({left, top}, colorOf(curve), text.c_str());
        top += line;
    }
}

PlotRange shownValues(const PlotSpec& spec, const PlotRange& x) {
    if (spec.yRange) {
        return *spec.yRange;
    }
    PlotRange range{1e300, -1e300};
    for (const PlotCurve& curve : spec.curves) {
        const PlotRange own = valueRange(bucketsIn(curve.series->buckets(), x));
        range.low = std::min(range.low, own.low);
        range.high = std::max(range.high, own.high);
    }
    if (spec.reference && range.low > range.high) {
        range = {spec.reference->value, spec.reference->value};
    }
    PlotRange padded = paddedRange(range, spec.minSpan);
    if (range.low >= 0 && padded.low < 0) {
        padded = {0, padded.high - padded.low};  // no room for negative values where there are none
    }
    return padded;
}

PlotFrame placeFrame(const PlotSpec& spec, const PlotTimeline& timeline, float height) {
    const float line = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton(spec.id, {width, std::max(height, 3 * line)});
    PlotFrame frame;
    const float labels = std::max(timeline.labels, labelsWidth(spec, timeline, height));
    frame.low = {std::round(corner.x + labels + 0.4F * line), std::round(corner.y)};
    frame.high = {std::round(corner.x + width),
                  std::round(corner.y + std::max(height, 3 * line) - 1.3F * line)};
    frame.x = rangeOf(timeline.view, timeline.newest);
    frame.y = shownValues(spec, frame.x);
    return frame;
}

/// The view that the pointer asks for, if it does; the last item is the plot.
std::optional<PlotView> answer(const PlotFrame& frame, const PlotTimeline& timeline) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered()) {
        ImGui::SetItemUsingMouseWheel();
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            return PlotView{};
        }
        if (io.MouseWheel != 0) {
            return zoomed(timeline.view, timeline.newest, io.MouseWheel,
                          frame.timeAt(io.MousePos.x), timeline.running);
        }
    }
    if (ImGui::IsItemActive() && io.MouseDelta.x != 0) {
        return panned(timeline.view, timeline.newest,
                      -io.MouseDelta.x / frame.width() * frame.x.span());
    }
    return std::nullopt;
}

}  // namespace

float labelsWidth(const PlotSpec& spec, const PlotTimeline& timeline, float height) {
    const float line = ImGui::GetFontSize();
    const PlotRange values = shownValues(spec, rangeOf(timeline.view, timeline.newest));
    const PlotTicks ticks = ticksY(values, height - 1.3F * line);
    float width = 2.5F * line;
    for (const double value : ticks.values) {
        width = std::max(width, ImGui::CalcTextSize(numberText(value, ticks.decimals).c_str()).x);
    }
    return width;
}

double newestOf(std::span<const PlotSpec> plots) {
    double newest = 0;
    for (const PlotSpec& plot : plots) {
        for (const PlotCurve& curve : plot.curves) {
            if (!curve.series->empty()) {
                newest = std::max(newest, curve.series->buckets().back().x);
            }
        }
    }
    return newest;
}

std::optional<PlotView> drawPlot(const PlotSpec& spec, const PlotTimeline& timeline, float height) {
    const float top = ImGui::GetCursorPosY();
    drawHeader(spec);
    const PlotFrame frame = placeFrame(spec, timeline, height - (ImGui::GetCursorPosY() - top));
    noteItem(std::string("plot.") + spec.id);
    const bool hovered = ImGui::IsItemHovered();
    std::optional<PlotView> view = answer(frame, timeline);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(frame.low, frame.high, palette().plotGround);
    drawTicksY(draw, frame);
    drawTicksX(draw, frame, spec.xUnit);
    draw.PushClipRect(frame.low, frame.high, true);
    drawMarks(draw, frame, spec.marks);
    for (const PlotCurve& curve : spec.curves) {
        drawCurve(draw, frame, curve);
    }
    if (spec.reference) {
        drawReference(draw, frame, *spec.reference);
    }
    draw.PopClipRect();
    draw.AddRect(frame.low, frame.high, palette().frame);
    const auto time = timeline.hovered ? timeUnderPointer(frame, spec) : std::nullopt;
    if (time) {
        drawCrosshair(draw, frame, spec, *time);
    }
    if (time && hovered && frame.holds(ImGui::GetMousePos())) {
        drawTooltip(spec, *time);
    } else if (time) {
        drawValues(draw, frame, spec, *time);
    }
    return view;
}

}  // namespace kerf::ui
