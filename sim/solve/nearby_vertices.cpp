#include "sim/solve/nearby_vertices.h"

#include <algorithm>
#include <cstring>

#include "shaders/shared/bindings.h"

namespace kerf {

namespace {

using shared::NearbyQuery;
using shared::NearbyVertex;
using shared::uint;

static_assert(sizeof(NearbyVertex) == 32);
static_assert(sizeof(NearbyQuery) == 96);
constexpr std::size_t kRecordsOfQuery = sizeof(NearbyQuery) / sizeof(NearbyVertex);

constexpr std::size_t kLeastCapacity = 8192;
// Floats of the kernel against doubles, of the distance from the origin and the size of the box.
constexpr double kRounding = 1e-5;

shared::vec4 packed(const Vec3& a, double w) {
    return {static_cast<float>(a.x()), static_cast<float>(a.y()), static_cast<float>(a.z()),
            static_cast<float>(w)};
}

void setBox(const std::optional<OrientedBox>& box, NearbyQuery& query) {
    query.asks_for_box = box ? 1 : 0;
    if (!box) {
        return;
    }
    const double rounding = kRounding * (box->center.cwiseAbs().maxCoeff() + box->half.maxCoeff());
    query.center = packed(box->center, 0);
    query.first_axis = packed(box->axes.col(0), box->half.x() + rounding);
    query.second_axis = packed(box->axes.col(1), box->half.y() + rounding);
    query.third_axis = packed(box->axes.col(2), box->half.z() + rounding);
}

}  // namespace

NearbyVertices::NearbyVertices() {
    ask(std::nullopt, {});
}

void NearbyVertices::ask(const std::optional<OrientedBox>& box, std::span<const int> asked) {
    setBox(box, query_);
    query_.asked_vertices = static_cast<uint>(asked.size());
    query_.capacity = std::max(query_.capacity, static_cast<uint>(kLeastCapacity + asked.size()));
    buffer_.resize((kRecordsOfQuery + query_.capacity) * sizeof(NearbyVertex));
    std::vector<NearbyVertex> records(asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        records[i].vertex = static_cast<uint>(asked[i]);
    }
    buffer_.write(kRecordsOfQuery, std::span<const NearbyVertex>(records));
    renew();
}

void NearbyVertices::renew() {
    query_.count = query_.asked_vertices;
    buffer_.write(0, std::span<const NearbyQuery>(&query_, 1));
}

void NearbyVertices::bind() const {
    buffer_.bindStorage(shared::kNearbyBinding);
}

void NearbyVertices::askFor(gpu::ReadBack& back) {
    const uint likely = query_.asks_for_box != 0 ? expected_ : 0;
    sent_ = std::min(query_.capacity, query_.asked_vertices + likely);
    place_ = back.ask(buffer_, (kRecordsOfQuery + sent_) * sizeof(NearbyVertex));
}

VertexStates NearbyVertices::take(const gpu::ReadBack& back) {
    const auto words = back.read<NearbyVertex>(place_, kRecordsOfQuery + sent_);
    NearbyQuery answer;
    std::memcpy(&answer, words.data(), sizeof answer);
    VertexStates out;
    out.complete = answer.count <= answer.capacity;
    const uint asked = query_.asked_vertices;
    const uint count = out.complete ? answer.count : asked;
    const auto records = words.subspan(kRecordsOfQuery, std::min(count, sent_));
    out.records.assign(records.begin(), records.end());
    if (count > sent_) {
        const auto rest = buffer_.read<NearbyVertex>(kRecordsOfQuery + sent_, count - sent_);
        out.records.insert(out.records.end(), rest.begin(), rest.end());
    }
    if (query_.asks_for_box != 0) {
        const uint ofBox = count - asked;
        expected_ = std::max(ofBox + ofBox / 4, kLeastExpected);
    }
    if (!out.complete) {
        query_.capacity = 2 * answer.count;
    }
    std::ranges::sort(out.records, {}, &NearbyVertex::vertex);
    const auto sameVertex = [](const NearbyVertex& a, const NearbyVertex& b) {
        return a.vertex == b.vertex;
    };
    out.records.erase(std::unique(out.records.begin(), out.records.end(), sameVertex),
                      out.records.end());
    ask(std::nullopt, {});
    return out;
}

}  // namespace kerf
