#include "sim/solve/body_measure.h"

#include <cstring>

#include "shaders/shared/bindings.h"
#include "shaders/shared/implicit_records.h"
#include "shaders/shared/unfold_records.h"

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

using gpu::TexelFormat;

Vec3 xyz(const shared::vec4& a) {
    return {a.x, a.y, a.z};
}

/// A measure, with what the next step of the solver counts on.
struct SolverMeasure {
    BodyMeasure body;
    Bounds velocities;    ///< of all vertices [m/s]
    Bounds ways;          ///< that they went since contacts were looked for [m]
    bool folded = false;  ///< some edge is folded (see Unfolding)
};

/// Whether a vertex on the block's pages is lost.
bool isLost(const shared::BlockMeasure& block) {
    return block.high_stretch.w == shared::kLostStretch;
}

/// Adds what one block measured.
void add(const shared::BlockMeasure& block, std::uint32_t piece, SolverMeasure& sum) {
    const shared::vec4& low = block.low_volume;
    sum.body.pieceVolumes[piece] += low.w;
    sum.body.kineticEnergy += block.low_velocity_kinetic.w;
    sum.body.potentialEnergy += block.high_velocity_potential.w;
    sum.body.strainEnergy += block.low_drift_strain.w;
    sum.folded = sum.folded || block.high_drift.w > 0;
    if (!isLost(block)) {
        sum.body.largestStretch =
            std::max(sum.body.largestStretch, static_cast<double>(block.high_stretch.w));
    }
    if (low.x > block.high_stretch.x) {
        return;  // all vertices of the block's pages have gone to other pieces
    }
    sum.body.pieceBounds[piece].add(xyz(low));
    sum.body.pieceBounds[piece].add(xyz(block.high_stretch));
    sum.velocities.add(xyz(block.low_velocity_kinetic));
    sum.velocities.add(xyz(block.high_velocity_potential));
    sum.ways.add(xyz(block.low_drift_strain));
    sum.ways.add(xyz(block.high_drift));
}

/// No vector of the box is longer; 0 where it is empty.
double mostLength(const Bounds& box) {
    return box.empty() ? 0.0 : box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm();
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

BodyMeasurer::BodyMeasurer(SolverBody& body, Collisions& collisions)
    : body_(body),
      collisions_(collisions),
      measure_(body.compile("measure", body.groupsOfSums())),
      collect_(gpu::Program::compute("sim/collect.comp")) {}

void BodyMeasurer::start() {
    const ContactReadings contacts = collisions_.readings();
    body_.bind();
    body_.pieces.blockMeasures.bindStorage(shared::kBlockSumsBinding);
    contacts.state.bindStorage(shared::kContactCountsOfStepBinding);
    // Of another body it has another size; candidates are then looked for anyway.
    const gpu::Buffer& searched = contacts.searched;
    const gpu::Buffer& positions = body_.state.positions;
    (searched.size() == positions.size() ? searched : positions)
        .bindStorage(shared::kSearchedBinding);
    if (nearby_.asks()) {
        nearby_.renew();
    }
    nearby_.bind();
    bindConstraints();
    body_.runOverBlocks(measure_);
    collect(nearby_, back_);
    collisions_.askForLoads(back_);
    if (watchesAll_) {
        all_ = body_.state.askFor(back_, body_.uniforms.vertex_count);
    }
    const std::size_t blocks = body_.pieces.blocks().size() + 1;
    place_ = back_.ask(body_.pieces.blockMeasures, blocks * sizeof(shared::BlockMeasure));
    const gpu::Buffer& courses = body_.state.courses;
    courseCount_ = courses.size() / sizeof(shared::Course);
    if (courseCount_ > 0) {
        courses_ = back_.ask(courses, courses.size());
    }
    back_.send();
}

std::optional<double> BodyMeasurer::residual(double least) const {
    if (courseCount_ == 0) {
        return std::nullopt;
    }
    double left = 0;
    double motion = 0;
    for (const shared::Course& course : back_.read<shared::Course>(courses_, courseCount_)) {
        left += std::max(course.size, 0.0F);
        motion += course.scale;
    }
    return std::sqrt(left / std::max(motion, least));
}

BodyMeasure BodyMeasurer::take() {
    const std::vector<shared::BlockRecord>& blocks = body_.pieces.blocks();
    const std::size_t pieceCount = body_.pieces.pieces().size();
    const auto measures = back_.read<shared::BlockMeasure>(place_, blocks.size() + 1);
    collisions_.takeLoads(back_);
    SolverMeasure out;
    BodyMeasure& body = out.body;
    body.pieceVolumes.assign(pieceCount, 0.0);
    body.pieceBounds.resize(pieceCount);
    std::vector<bool> lost(pieceCount, false);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        add(measures[b], blocks[b].piece, out);
        lost[blocks[b].piece] = lost[blocks[b].piece] || isLost(measures[b]);
    }
    for (std::size_t p = 0; p < pieceCount; ++p) {
        body.bounds.add(body.pieceBounds[p]);
        if (lost[p] || body.pieceBounds[p].diagonal() > kLargestPiece * body_.model.diagonal) {
            body.lostPieces.push_back(static_cast<int>(p));
        }
    }
    body.fastest = mostLength(out.velocities);
    const shared::vec4& ofContacts = measures[blocks.size()].low_volume;
    body.contacts = collisions_.readings().counts ? static_cast<int>(ofContacts.x) : 0;
    collisions_.expect(body.bounds, body.lostPieces.empty() ? out.velocities : Bounds{},
                       {.drift = out.ways.diagonal(),
                        .touching = body.contacts > 0,
                        .hasCandidates = ofContacts.y > 0,
                        .folded = out.folded});
    return std::move(body);
}

void BodyMeasurer::bindConstraints() const {
    bindAllConstraints(body_.model.constraints, [&](const auto& buffer, auto unit, auto texels) {
        body_.bindFetched(buffer, unit, texels);
    });
    body_.bindFetched(body_.model.restPositions, shared::kUnfoldRestBinding,
                      TexelFormat::float32x4);
}

BodyState BodyMeasurer::takeAll() {
    watchesAll_ = false;
    return SolverState::take(back_, all_);
}

VertexStates BodyMeasurer::statesOf(std::span<const int> vertices) {
    collected_.ask(std::nullopt, vertices);
    body_.bind();
    collect(collected_, collectedBack_);
    collectedBack_.send();
    return collected_.take(collectedBack_);
}

/// The kernel that measures finds them; what it measures besides is left where it is.
VertexStates BodyMeasurer::statesNear(const OrientedBox& box) {
    for (;;) {
        nearby_.ask(box, {});
        start();
        VertexStates found = nearby_.take(back_);
        if (found.complete) {
            return found;
        }
    }
}

/// Fills in the vertices that were asked for by number, and asks for the answer.
void BodyMeasurer::collect(NearbyVertices& query, gpu::ReadBack& back) {
    if (query.asked() > 0) {
        query.bind();
        body_.run(collect_, query.asked());
    }
    if (query.asks()) {
        query.askFor(back);
    }
}

}  // namespace kerf
