#include "sim/contact/paper_contact.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "sim/base/boxes.h"
#include "sim/contact/octree.h"
#include "sim/mesh/triangle.h"

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

/// The triangles of one piece and where they are.
struct PieceSurface {
    std::vector<int> triangles;
    std::vector<Corners> corners;
    Bounds box;
};

/// What the triangles at a vertex ask of its velocity.
struct Asked {
    Vec3 sum = Vec3::Zero();
    int count = 0;
};

class PaperContact {
  public:
    PaperContact(const BodyModel& model, BodyState& state)
        : model_(model), state_(state), surfaces_(surfaces()), asked_(state.positions.size()) {}

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

    void apply(double timeStep) {
        for (std::size_t v = 0; v < asked_.size(); ++v) {
            if (asked_[v].count > 0) {
                const Vec3 change = asked_[v].sum / asked_[v].count;
                state_.velocities[v] += change.cast<float>();
                state_.positions[v] += (timeStep * change).cast<float>();
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
                    respond(a.triangles[i], b.triangles[j]);
                    ++pairs;
                }
            });
        }
        return pairs;
    }

    Vec3 meanVelocity(int triangle) const {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            sum += state_.velocities[model_.triangles[triangle][k]].cast<double>();
        }
        return sum / 3;
    }

    void respond(int a, int b) {
        const Vec3 relative = meanVelocity(a) - meanVelocity(b);
        ask(a, -0.5 * relative);
        ask(b, 0.5 * relative);
    }

    void ask(int triangle, const Vec3& change) {
        for (int k = 0; k < 3; ++k) {
            Asked& asked = asked_[model_.triangles[triangle][k]];
            asked.sum += change;
            ++asked.count;
        }
    }

    const BodyModel& model_;
    BodyState& state_;
    std::vector<PieceSurface> surfaces_;
    std::vector<Asked> asked_;
};

}  // namespace

int respondAsThePaper(const BodyModel& model, double timeStep, BodyState& state) {
    PaperContact contact(model, state);
    const int pairs = contact.collide();
    contact.apply(timeStep);
    return pairs;
}

}  // namespace kerf
