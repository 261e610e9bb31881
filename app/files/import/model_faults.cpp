#include "app/files/import/model_faults.h"

#include "sim/base/text.h"

namespace kerf::app {

namespace {

using repair::FaultKind;

/// How a kind of fault is called and drawn.
struct KindInfo {
    const char* one;
    const char* many;
    render::DisplayColor color;
};

/// By FaultKind. Okabe and Ito's colours, which most people with colour blindness tell apart, and
/// white.
constexpr std::array<KindInfo, repair::kFaultKinds> kKinds{{
    {"open edge", "open edges", {213, 94, 0}},
    {"edge of more than two triangles", "edges of more than two triangles", {240, 228, 66}},
    {"vertex where it touches itself", "vertices where it touches itself", {86, 180, 233}},
    {"edge of triangles that face opposite ways",
     "edges of triangles that face opposite ways",
     {204, 121, 167}},
    {"triangle without area", "triangles without area", {255, 255, 255}},
    {"double of a triangle", "doubles of triangles", {0, 158, 115}},
    {"triangle that passes through others", "triangles that pass through others", {0, 114, 178}},
    {"sliver", "slivers", {230, 159, 0}},
}};

void addLine(render::Marks& marks, int a, int b) {
    marks.lines.push_back(static_cast<std::uint32_t>(a));
    marks.lines.push_back(static_cast<std::uint32_t>(b));
}

void addTriangle(render::Marks& marks, const Triangle& corners) {
    for (int i = 0; i < 3; ++i) {
        addLine(marks, corners[i], corners[(i + 1) % 3]);
    }
}

}  // namespace

std::string labelOf(repair::FaultKind kind, int count) {
    const KindInfo& info = kKinds[static_cast<std::size_t>(kind)];
    return counted(count, info.one, info.many);
}

std::vector<render::Marks> marksOf(
    const repair::Faults& faults,
    const std::function<std::optional<Triangle>(int triangle)>& cornersOf) {
    std::vector<render::Marks> all;
    for (int k = 0; k < repair::kFaultKinds; ++k) {
        const auto kind = static_cast<FaultKind>(k);
        const repair::FaultLocations& places = faults.of(kind);
        if (places.count() == 0) {
            continue;
        }
        render::Marks& marks = all.emplace_back();
        marks.label = labelOf(kind, places.count());
        marks.color = kKinds[k].color;
        for (const auto& [a, b] : places.edges) {
            addLine(marks, a, b);
        }
        for (const int v : places.vertices) {
            marks.dots.push_back(static_cast<std::uint32_t>(v));
        }
        for (const int t : places.triangles) {
            const std::optional<Triangle> corners = cornersOf(t);
            if (corners && kind == FaultKind::flatTriangle) {  // It may be no more than a point.
                marks.dots.push_back(static_cast<std::uint32_t>((*corners)[0]));
            }
            if (corners) {
                addTriangle(marks, *corners);
            }
        }
    }
    return all;
}

std::vector<render::Marks> marksOf(const FoundFaults& found) {
    const auto hasPlace = [&](std::uint32_t v) { return found.soup.positions[v].allFinite(); };
    std::vector<render::Marks> all =
        marksOf(found.faults, [&](int t) { return std::optional(found.soup.triangles[t]); });
    for (render::Marks& marks : all) {
        std::erase_if(marks.dots, [&](std::uint32_t v) { return !hasPlace(v); });
        const std::vector<std::uint32_t> lines = std::exchange(marks.lines, {});
        for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
            if (hasPlace(lines[i]) && hasPlace(lines[i + 1])) {
                marks.lines.push_back(lines[i]);
                marks.lines.push_back(lines[i + 1]);
            }
        }
    }
    return all;
}

}  // namespace kerf::app
