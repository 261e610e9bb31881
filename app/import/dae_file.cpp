#include "app/import/dae_file.h"

#include <sstream>

#include "app/files/io/errors.h"
#include "app/files/io/text_lines.h"
#include "app/import/polygon_triangles.h"
#include "app/import/xml_file.h"
#include "sim/base/math.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

std::vector<std::string> wordsIn(const char* text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

/// Names of files keep the blanks in them.
struct BlankWalker : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override {
        constexpr int kDeepest = 500;
        if (depth() > kDeepest) {
            throw InputError("its elements are nested more than 500 deep");
        }
        if (node.type() == pugi::node_pcdata && node.parent().name() != std::string("init_from")) {
            node.set_value(joined(wordsIn(node.value()), " ").c_str());
        }
        return true;
    }
};

/// A corner of a polygon: the words that name it, and its place.
struct DaeCorner {
    std::string words;
    Vec3 at;
};
using DaeLoop = std::vector<DaeCorner>;

/// Reads the corners of a <polygons>.
std::function<DaeLoop(const pugi::xml_node&)> loopReader(const pugi::xml_node& polygons) {
    const auto idIn = [](const pugi::xml_attribute& url) {
        return std::string(url.value()).substr(url.empty() ? 0 : 1);
    };
    std::size_t stride = 1;
    for (const pugi::xml_node input : polygons.children("input")) {
        stride = std::max<std::size_t>(stride, input.attribute("offset").as_uint() + 1);
    }
    const std::size_t vertex = polygons.find_child_by_attribute("input", "semantic", "VERTEX")
                                   .attribute("offset")
                                   .as_uint();
    const pugi::xml_node mesh = polygons.parent();
    const pugi::xml_node places =
        mesh.child("vertices").find_child_by_attribute("input", "semantic", "POSITION");
    const pugi::xml_node source =
        mesh.find_child_by_attribute("source", "id", idIn(places.attribute("source")).c_str());
    const pugi::xml_node accessor = source.child("technique_common").child("accessor");
    const double first = accessor.attribute("offset").as_uint();
    const double step = accessor.attribute("stride").as_uint(3);
    const std::vector<std::string> numbers = wordsIn(source.child("float_array").text().get());
    return [=](const pugi::xml_node& list) {
        const std::vector<std::string> words = wordsIn(list.text().get());
        DaeLoop loop;
        for (std::size_t i = 0; i + stride <= words.size(); i += stride) {
            const double at = first + step * numberOf(words[i + vertex]);
            if (!(at >= 0 && at + 2 < static_cast<double>(numbers.size()))) {
                throw InputError("a polygon with a hole names vertex " + words[i + vertex] +
                                 ", which is not there");
            }
            const auto* const place = &numbers[static_cast<std::size_t>(at)];
            loop.push_back({joined(std::span(words).subspan(i, stride), " "),
                            {numberOf(place[0]), numberOf(place[1]), numberOf(place[2])}});
        }
        return loop;
    };
}

Vec3 areaOf(const DaeLoop& loop) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        area += loop[i].at.cross(loop[(i + 1) % loop.size()].at);
    }
    return area;
}

/// With a bridge to a hole and back, the shortest that crosses nothing.
DaeLoop bridged(const DaeLoop& outline, DaeLoop hole) {
    if (areaOf(outline).dot(areaOf(hole)) > 0) {
        std::ranges::reverse(hole);
    }
    std::multimap<double, std::array<std::ptrdiff_t, 2>> bridges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        for (std::size_t k = 0; k < hole.size(); ++k) {
            bridges.insert(
                {(outline[i].at - hole[k].at).norm(), {std::ptrdiff_t(i), std::ptrdiff_t(k)}});
        }
    }
    for (const auto& [length, ends] : bridges) {
        const auto from = outline.begin() + ends[0];
        DaeLoop loop(outline.begin(), from + 1);
        std::ranges::rotate_copy(hole, hole.begin() + ends[1], std::back_inserter(loop));
        loop.push_back(hole[ends[1]]);
        loop.insert(loop.end(), from, outline.end());
        std::vector<Vec3> places(loop.size());
        std::ranges::transform(loop, places.begin(), &DaeCorner::at);
        if (!triangulatePolygon(places).empty()) {
            return loop;
        }
    }
    throw InputError("a hole of a polygon crosses its outline; export it as triangles");
}

/// <ph>: an outline, then its holes.
void bridgeHoles(const pugi::xml_node& polygons) {
    const auto loopOf = loopReader(polygons);
    for (pugi::xml_node polygon : polygons.children("ph")) {
        DaeLoop loop = loopOf(polygon.child("p"));
        for (const pugi::xml_node hole : polygon.children("h")) {
            loop = bridged(loop, loopOf(hole));
        }
        polygon.remove_children();
        polygon.set_name("p");
        polygon.text().set(joined(loop, " ", &DaeCorner::words).c_str());
    }
}

}  // namespace

std::string plainDae(std::string_view bytes) {
    pugi::xml_document document;
    loadXml(bytes, document);
    BlankWalker blanks;
    document.traverse(blanks);
    for (const auto& found : document.select_nodes("//polygons[ph]")) {
        bridgeHoles(found.node());
    }
    std::ostringstream text;
    document.save(text, "", pugi::format_raw, pugi::encoding_utf8);
    return std::move(text).str();
}

}  // namespace kerf::app
