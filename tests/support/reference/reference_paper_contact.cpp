#include "tests/support/reference/reference_paper_contact.h"

#include <Eigen/Geometry>

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"
#include "tests/support/reference/octree.h"

namespace kerf {

namespace {

/// Whether the edge from p to q meets a triangle (Möller and Trumbore, 1997).
bool meets(const Vec3& p, const Vec3& q, const Corners& t) {
    const Vec3 way = q - p;
    const Vec3 first = t[1] - t[0];
    const Vec3 second = t[2] - t[0];
    const Vec3 across = way.cross(second);
    const double scale = first.dot(across);
    if (scale == 0) {
        return false;
    }
    const Vec3 from = p - t[0];
    const double u = from.dot(across) / scale;
    const Vec3 over = from.cross(first);
    const double v = way.dot(over) / scale;
    const double along = second.dot(over) / scale;
    return u >= 0 && v >= 0 && u + v <= 1 && along >= 0 && along <= 1;
}

bool intersect(const Corners& a, const Corners& b) {
    for (int k = 0; k < 3; ++k) {
        if (meets(a[k], a[(k + 1) % 3], b) || meets(b[k], b[(k + 1) % 3], a)) {
            return true;
        }
    }
    return false;
}

Vec3 normalOf(const Corners& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

/// The triangles of one piece and where they are.
struct PieceSurface {
    std::vector<int> triangles;
    std::vector<Corners> corners;
    Bounds box;
};

/// What the triangles at a vertex ask of it.
struct Asked {
    Vec3 loss = Vec3::Zero();  ///< of velocity, as the way of a time step [m]
    Vec3 push = Vec3::Zero();  ///< of its position alone [m]
    int count = 0;
};

class ReferencePaperContact {
  public:
    ReferencePaperContact(const BodyModel& model, const shared::ContactUniforms& uniforms,
                          BodyState& state)
        : model_(model),
          uniforms_(uniforms),
          state_(state),
          surfaces_(surfaces()),
          asked_(state.positions.size()) {}

    int collide() {
        int pairs = 0;
        for (std::size_t a = 0; a < surfaces_.size(); ++a) {
            for (std::size_t b = a + 1; b < surfaces_.size(); ++b) {
                if (surfaces_[a].box.overlaps(surfaces_[b].box)) {
                    pairs += collide(surfaces_[a], surfaces_[b]);
                }
            }
        }
        return pairs;
    }

    void apply() {
        for (std::size_t v = 0; v < asked_.size(); ++v) {
            if (const Asked& asked = asked_[v]; asked.count > 0) {
                const Vec3 loss = asked.loss / asked.count;
                state_.velocities[v] += (loss / uniforms_.interval).cast<float>();
                state_.positions[v] += (loss + asked.push / asked.count).cast<float>();
            }
        }
    }

  private:
    std::vector<PieceSurface> surfaces() const {
        std::vector<PieceSurface> out(model_.pieces.size());
        for (std::size_t t = 0; t < model_.triangles.size(); ++t) {
            const auto& record = model_.triangles[t];
            PieceSurface& piece = out[record[3] >> 8];
            Corners corners;
            for (int k = 0; k < 3; ++k) {
                corners[k] = state_.positions[record[k]].cast<double>();
                piece.box.add(corners[k]);
            }
            piece.triangles.push_back(static_cast<int>(t));
            piece.corners.push_back(corners);
        }
        return out;
    }

    static Octree treeOf(const PieceSurface& surface) {
        std::vector<Bounds> boxes;
        for (const Corners& corners : surface.corners) {
            boxes.push_back(boxOf(corners));
        }
        return Octree(std::move(boxes));
    }

    int collide(const PieceSurface& a, const PieceSurface& b) {
        const Octree tree = treeOf(b);
        int pairs = 0;
        for (std::size_t i = 0; i < a.triangles.size(); ++i) {
            const Bounds box = boxOf(a.corners[i]);
            if (!box.overlaps(b.box)) {
                continue;
            }
            tree.query(box, [&](int j) {
                if (intersect(a.corners[i], b.corners[j])) {
                    respond(a.triangles[i], b.triangles[j], wayOut(a, static_cast<int>(i), b, j));
                    ++pairs;
                }
            });
        }
        return pairs;
    }

    /// Where triangle i of a gets out of triangle j of b.
    static Vec3 wayOut(const PieceSurface& a, int i, const PieceSurface& b, int j) {
        const Vec3 apart = normalOf(b.corners[j]) - normalOf(a.corners[i]);
        const bool tells = apart.squaredNorm() > shared::kFacesAlike;
        return (tells ? apart : Vec3(a.box.center() - b.box.center())).normalized();
    }

    Vec3 meanVelocity(int triangle) const {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            sum += state_.velocities[model_.triangles[triangle][k]].cast<double>();
        }
        return sum / 3;
    }

    void respond(int a, int b, const Vec3& apart) {
        const Vec3 relative = uniforms_.interval * (meanVelocity(a) - meanVelocity(b));
        const double speed = relative.norm();
        const bool closing = -relative.dot(apart) > shared::kStandsStill * uniforms_.margin;
        const Vec3 against = closing ? Vec3(-relative / speed) : Vec3::Zero();
        const Vec3 loss = std::min(0.5 * speed, static_cast<double>(uniforms_.reach)) * against;
        const Vec3 push = 0.5 * uniforms_.margin * apart;
        ask(a, loss, push);
        ask(b, -loss, -push);
    }

    void ask(int triangle, const Vec3& loss, const Vec3& push) {
        for (int k = 0; k < 3; ++k) {
            Asked& asked = asked_[model_.triangles[triangle][k]];
            asked.loss += loss;
            asked.push += push;
            ++asked.count;
        }
    }

    const BodyModel& model_;
    const shared::ContactUniforms& uniforms_;
    BodyState& state_;
    std::vector<PieceSurface> surfaces_;
    std::vector<Asked> asked_;
};

}  // namespace

int respondAsThePaper(const BodyModel& model, const shared::ContactUniforms& uniforms,
                      BodyState& state) {
    ReferencePaperContact contact(model, uniforms, state);
    const int pairs = contact.collide();
    contact.apply();
    return pairs;
}

}  // namespace kerf
