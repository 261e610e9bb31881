#include "tests/support/reference/implicit/implicit_solver.h"

#include "shaders/shared/implicit_records.h"
#include "sim/base/containers.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"

namespace kerf {

namespace {

StageScale scaleOf(const ImplicitSettings& settings) {
    return stageScale(settings.step, settings.damping);
}

double preparedStep(const ImplicitSettings& settings) {
    return settings.prepared > 0 ? settings.prepared : settings.step;
}

StageScale preparedScaleOf(const ImplicitSettings& settings) {
    return stageScale(preparedStep(settings), settings.damping);
}

double firmestOf(const ImplicitSettings& settings) {
    return firmestIn(preparedStep(settings));
}

/// Changes with vertices `i` and `j` of a pull.
Eigen::Matrix3d stiffnessBetween(const ConstraintPull& pull, int i, int j, double damping) {
    Eigen::Matrix3d block = pull.stiffness * (pull.secant + damping) * pull.gradients[i] *
                            pull.gradients[j].transpose();
    if (pull.across > 0) {
        block += pull.across * pull.weights[i] * pull.weights[j] *
                 (Eigen::Matrix3d::Identity() - pull.direction * pull.direction.transpose());
    }
    return block;
}

/// One of each piece, about which its volume is measured.
std::vector<Vec3> originsOf(const BodyModel& model, std::span<const Vec3> positions) {
    std::vector<Vec3> origins(model.pieces.size(), Vec3::Zero());
    for (const auto& triangle : model.triangles) {
        origins[model.pieceOfVertex[triangle[0]]] = positions[triangle[0]];
    }
    return origins;
}

std::vector<double> volumesOf(const BodyModel& model, std::span<const Vec3> positions,
                              Vectors* gradient) {
    const std::vector<Vec3> origins = originsOf(model, positions);
    std::vector<double> volumes(model.pieces.size(), 0.0);
    for (const auto& triangle : model.triangles) {
        const int piece = model.pieceOfVertex[triangle[0]];
        const Vec3 a = positions[triangle[0]] - origins[piece];
        const Vec3 b = positions[triangle[1]] - origins[piece];
        const Vec3 c = positions[triangle[2]] - origins[piece];
        volumes[piece] += a.dot(b.cross(c)) / 6;
        if (gradient != nullptr) {
            (*gradient)[triangle[0]] += b.cross(c) / 6;
            (*gradient)[triangle[1]] += c.cross(a) / 6;
            (*gradient)[triangle[2]] += a.cross(b) / 6;
        }
    }
    return volumes;
}

/// a + factor * b.
Vectors sumOf(const Vectors& a, double factor, const Vectors& b) {
    Vectors sum(a.size());
    for (std::size_t v = 0; v < a.size(); ++v) {
        sum[v] = a[v] + factor * b[v];
    }
    return sum;
}

/// What holds back at a slip [N/m]: less where friction does not hold it.
double gripOf(const ContactRow& row, const Vec3& slip, double most) {
    const double length = slip.norm();
    return row.stiffness * length > most ? most / length : row.stiffness;
}

/// How a vertex moves; `given`: momentum, with what forces add to it.
struct Moving {
    Vec3 place, speed, given;
};

/// Of what moves together in a step, sums of mass and momentum.
struct Turning {
    bool isFree = true;
    double mass = 0;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< mass times place
    Vec3 momentum = Vec3::Zero(), ended = Vec3::Zero();
    Vec3 turn = Vec3::Zero(), endedTurn = Vec3::Zero();  ///< about the origin
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

    void add(double m, const Moving& before, const Moving& after) {
        isFree = isFree && m > 0;
        mass += m;
        from += m * before.place;
        to += m * after.place;
        momentum += m * before.speed;
        ended += m * after.speed;
        turn += before.place.cross(before.given);
        endedTurn += m * after.place.cross(after.speed);
        squares += m * after.place * after.place.transpose();
    }
    /// Of the velocity at a place.
    Vec3 changeAt(const Vec3& place, double kept) const {
        const Vec3 middle = to / mass;
        const Eigen::Matrix3d about = squares - mass * middle * middle.transpose();
        const Eigen::Matrix3d inertia = about.trace() * Eigen::Matrix3d::Identity() - about;
        const Vec3 lacks =
            kept * (turn - from.cross(momentum) / mass) - (endedTurn - to.cross(ended) / mass);
        const Vec3 spin = inertia.ldlt().solve(lacks);
        return spin.cross(place - middle);
    }
};

}  // namespace

ImplicitSettings implicitSettings(const Params& params) {
    ImplicitSettings settings;
    settings.moduli = typeModuli(params);
    settings.density = params.density;
    settings.damping = params.damping;
    settings.drag = params.airDrag;
    settings.gravity = params.gravity;
    settings.holdsVolume = holdsVolume(params);
    return settings;
}

ImplicitReference::ImplicitReference(const BodyModel& model, const ImplicitSettings& settings,
                                     std::span<const std::uint32_t> pinned)
    : model_(model),
      settings_(settings),
      masses_(massesWithout(model, settings.density, pinned)),
      pulls_(boundedPullsAtRest(model, settings.moduli, masses_, firmestOf(settings))),
      firmness_(contactFirmness(pulls_, masses_.size())),
      groups_(groupVertices(model, pulls_, settings.aggregateSize)),
      inverse_(invertAtRest(model, pulls_, groups_, masses_, preparedScaleOf(settings))),
      preconditioner_(model, groups_, inverse_, masses_),
      steepness_(bendSteepness(model)),
      matrix_(model) {}

std::vector<double> ImplicitReference::volumes(std::span<const Vec3> positions) const {
    return volumesOf(model_, positions, nullptr);
}

double ImplicitReference::energy(const ReferenceState& state) const {
    double sum = 0;
    for (std::size_t v = 0; v < masses_.size(); ++v) {
        sum += masses_[v] * (0.5 * state.velocities[v].squaredNorm() -
                             settings_.gravity.dot(state.positions[v]));
    }
    forEachPull(model_, settings_.moduli, steepness_, state.positions, [&](ConstraintPull pull) {
        boundFirmness(pull, masses_, firmestOf(settings_));
        const double value = std::fabs(pull.value);
        sum += pull.stiffness * value * (value / pull.secant - 0.5 * value);
    });
    return sum;
}

void ImplicitReference::linearise(const Vectors& positions) {
    const double damping = scaleOf(settings_).damped - 1;
    matrix_.clear();
    pulls_.clear();
    force_.assign(positions.size(), Vec3::Zero());
    forEachPull(model_, settings_.moduli, steepness_, positions, [&](ConstraintPull pull) {
        boundFirmness(pull, masses_, firmestOf(settings_));
        pulls_.push_back(pull);
        for (int i = 0; i < pull.count; ++i) {
            force_[pull.vertices[i]] -= pull.stiffness * pull.value * pull.gradients[i];
            for (int j = 0; j < pull.count; ++j) {
                matrix_.add(pull.vertices[i], pull.vertices[j],
                            stiffnessBetween(pull, i, j, damping));
            }
        }
    });
    const double inertia = scaleOf(settings_).inertia;
    for (std::uint32_t v = 0; v < masses_.size(); ++v) {
        matrix_.add(v, v, inertia * masses_[v] * Eigen::Matrix3d::Identity());
    }
    volumeGradient_.assign(positions.size(), Vec3::Zero());
    volume_ = volumesOf(model_, positions, &volumeGradient_);
    for (std::size_t v = 0; v < masses_.size(); ++v) {
        if (masses_[v] <= 0) {
            volumeGradient_[v].setZero();
        }
    }
    preconditioner_.turn(positions);
}

/// Conjugate gradients over the displacements of a stage: energy is quadratic but for contacts,
/// which push only inside. Pieces that touch each other share their scalars.
class ImplicitReference::Descent {
  public:
    Descent(const ImplicitReference& solver, Vectors residual, ContactRows& rows)
        : solver_(solver),
          rows_(rows),
          residual_(std::move(residual)),
          displacement_(residual_.size(), Vec3::Zero()),
          joined_(solver.model_.pieces.size()) {
        for (ContactRow& row : rows_) {
            gaps_.push_back(row.gap);
            slips_.push_back(row.slip);
            grips_.push_back(row.friction * row.push);
            for (int k = 1; k < row.count; ++k) {
                joined_.join(pieceOf(row.vertices[0]), pieceOf(row.vertices[k]));
            }
        }
        clearFixed(residual_);
        if (solver.settings_.holdsVolume) {
            volumeAnswer_ = solver.preconditioner_.apply(solver.volumeGradient_);
            volumeSize_ = byPiece(solver.volumeGradient_, volumeAnswer_);
        }
    }

    /// Moves so that each piece has so much more volume [m^3].
    void addVolume(const std::vector<double>& wanted) {
        Vectors step(displacement_.size(), Vec3::Zero());
        giveVolume(step, wanted);
        move(step, std::vector<double>(wanted.size(), 1.0));
    }
    /// Goes as far as is best along a direction that keeps volumes.
    void goAlong(Vectors direction) {
        clearFixed(direction);
        giveVolume(direction, std::vector<double>(solver_.volume_.size(), 0.0));
        searchAlong(direction);
    }
    /// Returns the residual as a share of that before.
    double iterate(int iterations, double tolerance) {
        takePressure();
        Vectors gradient = gradientNow();
        Vectors answer = answerTo(gradient);
        Vectors direction = answer;
        std::vector<double> size = byGroup(gradient, answer);
        const std::vector<double> first = size;
        for (int i = 0; i < iterations; ++i) {
            stopSettled(size, first, direction);
            searchAlong(direction);
            if (i + 1 == iterations / 2) {
                renewGrips();
            }
            const Vectors before = std::exchange(gradient, gradientNow());
            answer = answerTo(gradient);
            const std::vector<double> now = byGroup(gradient, answer);
            const std::vector<double> mixed = byGroup(before, answer);
            for (std::size_t v = 0; v < direction.size(); ++v) {
                const int g = groupOf(v);
                const double beta =
                    g >= 0 && size[g] > 0 ? std::max(0.0, (now[g] - mixed[g]) / size[g]) : 0.0;
                direction[v] = answer[v] + beta * direction[v];
            }
            size = now;
            if (ratio(size, first) < tolerance) {
                break;
            }
        }
        return ratio(size, first);
    }
    /// Moves what holds no vertex as a whole, so that it has the momentum that it should.
    void balance() {
        const std::size_t count = solver_.model_.pieces.size();
        std::vector<Vec3> force(count, Vec3::Zero());
        std::vector<double> inertia(count, 0.0);
        std::vector<bool> isFree(count, true);
        const Vectors gradient = gradientNow();
        const double scale = scaleOf(solver_.settings_).inertia;
        for (std::size_t v = 0; v < gradient.size(); ++v) {
            if (const int g = groupOf(v); g >= 0) {
                force[g] += gradient[v];
                inertia[g] += scale * solver_.masses_[v];
                isFree[g] = isFree[g] && solver_.masses_[v] > 0;
            }
        }
        for (std::size_t v = 0; v < gradient.size(); ++v) {
            if (const int g = groupOf(v); g >= 0 && isFree[g]) {
                displacement_[v] += force[g] / inertia[g];
            }
        }
    }
    const Vectors& displacement() const { return displacement_; }
    /// Leaves in the rows what they push and hold.
    void finish(ImplicitReport& report) {
        report.pushing = 0;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            rows_[k].push = rows_[k].pushAt(gaps_[k]).force;
            report.pushing += rows_[k].push > 0;
        }
    }
    const std::vector<Vec3>& slips() const { return slips_; }

  private:
    int pieceOf(std::uint32_t v) const { return solver_.model_.pieceOfVertex[v]; }
    int groupOf(std::size_t v) {
        const int piece = solver_.model_.pieceOfVertex[v];
        return piece < 0 ? -1 : joined_.root(piece);
    }
    void clearFixed(Vectors& x) const {
        for (std::size_t v = 0; v < x.size(); ++v) {
            if (solver_.masses_[v] <= 0) {
                x[v].setZero();
            }
        }
    }
    std::vector<double> byPiece(const Vectors& a, const Vectors& b) const {
        std::vector<double> sums(solver_.model_.pieces.size(), 0.0);
        for (std::size_t v = 0; v < a.size(); ++v) {
            if (const int p = solver_.model_.pieceOfVertex[v]; p >= 0) {
                sums[p] += a[v].dot(b[v]);
            }
        }
        return sums;
    }
    std::vector<double> byGroup(const Vectors& a, const Vectors& b) {
        std::vector<double> sums = byPiece(a, b);
        std::vector<double> groups(sums.size(), 0.0);
        for (std::size_t p = 0; p < sums.size(); ++p) {
            groups[joined_.root(static_cast<int>(p))] += sums[p];
        }
        return groups;
    }
    static double ratio(const std::vector<double>& now, const std::vector<double>& first) {
        double a = 0;
        double b = 0;
        for (std::size_t g = 0; g < now.size(); ++g) {
            a += std::max(0.0, now[g]);
            b += std::max(0.0, first[g]);
        }
        return b > 0 ? std::sqrt(a / b) : 0.0;
    }
    /// Changes a step so that each piece that holds its volume gains what is wanted.
    void giveVolume(Vectors& step, const std::vector<double>& wanted) const {
        if (volumeAnswer_.empty()) {
            return;
        }
        const std::vector<double> gained = byPiece(solver_.volumeGradient_, step);
        for (std::size_t v = 0; v < step.size(); ++v) {
            const int p = solver_.model_.pieceOfVertex[v];
            if (p >= 0 && volumeSize_[p] > 0 && solver_.model_.pieces[p].holdsVolume) {
                step[v] += (wanted[p] - gained[p]) / volumeSize_[p] * volumeAnswer_[v];
            }
        }
    }
    /// Pressure, which volumes answer, is most of the residual: what is left would drown in it.
    void takePressure() {
        if (volumeAnswer_.empty()) {
            return;
        }
        const std::vector<double> pressed = byPiece(volumeAnswer_, residual_);
        for (std::size_t v = 0; v < residual_.size(); ++v) {
            const int p = solver_.model_.pieceOfVertex[v];
            if (p >= 0 && volumeSize_[p] > 0 && solver_.model_.pieces[p].holdsVolume) {
                residual_[v] -= pressed[p] / volumeSize_[p] * solver_.volumeGradient_[v];
            }
        }
    }
    /// Where nothing but rounding is left a direction means nothing.
    void stopSettled(const std::vector<double>& size, const std::vector<double>& first,
                     Vectors& direction) {
        constexpr double kRounding = 1e-20;
        for (std::size_t v = 0; v < direction.size(); ++v) {
            if (const int g = groupOf(v); g < 0 || !(size[g] > kRounding * first[g])) {
                direction[v].setZero();
            }
        }
    }
    Vectors answerTo(const Vectors& gradient) const {
        Vectors answer = solver_.preconditioner_.apply(gradient);
        giveVolume(answer, std::vector<double>(solver_.volume_.size(), 0.0));
        return answer;
    }
    Vec3 gripForce(std::size_t k, const Vec3& slip) const {
        return -gripOf(rows_[k], slip, grips_[k]) * slip;
    }
    void renewGrips() {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            grips_[k] = rows_[k].friction * std::max(0.0, rows_[k].pushAt(gaps_[k]).force);
        }
    }
    Vectors gradientNow() const {
        Vectors gradient = residual_;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            Vec3 force = rows_[k].pushAt(gaps_[k]).force * rows_[k].normal;
            if (grips_[k] > 0) {
                force += gripForce(k, slips_[k]);
            }
            rows_[k].addForce(force, gradient);
        }
        clearFixed(gradient);
        return gradient;
    }
    void move(const Vectors& step, const std::vector<double>& byRoot) {
        Vectors change = solver_.matrix_.times(step);
        move(step, change, byRoot);
    }
    void move(const Vectors& step, const Vectors& change, const std::vector<double>& alphas) {
        Vectors moved(step.size(), Vec3::Zero());
        for (std::size_t v = 0; v < step.size(); ++v) {
            if (const int g = groupOf(v); g >= 0) {
                moved[v] = alphas[g] * step[v];
                residual_[v] -= alphas[g] * change[v];
                displacement_[v] += moved[v];
            }
        }
        clearFixed(residual_);
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Vec3 relative = rows_[k].relative(moved);
            gaps_[k] += rows_[k].normal.dot(relative);
            slips_[k] += rows_[k].across(relative);
        }
    }
    /// Newton's method for the length along a direction, which has kinks where contacts begin.
    void searchAlong(const Vectors& direction) {
        constexpr int kMost = 6;
        const Vectors change = solver_.matrix_.times(direction);
        const std::vector<double> curve = byGroup(direction, change);
        const std::vector<double> slope = byGroup(direction, residual_);
        std::vector<Vec3> relative;
        for (const ContactRow& row : rows_) {
            relative.push_back(row.relative(direction));
        }
        std::vector<double> alphas(curve.size(), 0.0);
        for (int turn = 0; turn < kMost; ++turn) {
            std::vector<double> first(curve.size());
            std::vector<double> second = curve;
            for (std::size_t g = 0; g < curve.size(); ++g) {
                first[g] = alphas[g] * curve[g] - slope[g];
            }
            addContacts(relative, alphas, first, second);
            bool settled = true;
            for (std::size_t g = 0; g < curve.size(); ++g) {
                const double step = curve[g] > 0 ? -first[g] / second[g] : 0.0;
                alphas[g] += step;
                settled = settled && std::fabs(step) <= 1e-4 * std::fabs(alphas[g]);
            }
            if (settled || rows_.empty()) {
                break;
            }
        }
        move(direction, change, alphas);
    }
    void addContacts(const std::vector<Vec3>& relative, const std::vector<double>& alphas,
                     std::vector<double>& first, std::vector<double>& second) {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const ContactRow& row = rows_[k];
            const int g = joined_.root(pieceOf(row.vertices[0]));
            const double opening = row.normal.dot(relative[k]);
            const ContactRow::Push push = row.pushAt(gaps_[k] + alphas[g] * opening);
            first[g] -= push.force * opening;
            second[g] += push.firmness * opening * opening;
            if (grips_[k] > 0) {
                const Vec3 across = row.across(relative[k]);
                const Vec3 slip = slips_[k] + alphas[g] * across;
                first[g] -= gripForce(k, slip).dot(across);
                second[g] += gripOf(row, slip, grips_[k]) * across.squaredNorm();
            }
        }
    }

    const ImplicitReference& solver_;
    ContactRows& rows_;
    Vectors residual_;  ///< without contacts
    Vectors displacement_;
    UnionFind joined_;  ///< pieces
    std::vector<double> gaps_;
    std::vector<Vec3> slips_;
    std::vector<double> grips_;  ///< most that friction holds [N]
    Vectors volumeAnswer_;
    std::vector<double> volumeSize_;
};

Vectors ImplicitReference::residualAt(const Vectors& total, const Vectors& start,
                                      const StageStart& from) const {
    const double s = scaleOf(settings_).stage;
    const double inertia = scaleOf(settings_).inertia;
    Vectors residual(start.size());
    for (std::size_t v = 0; v < start.size(); ++v) {
        const Vec3 free = from.positions[v] + s * from.velocities[v] + s * s * settings_.gravity;
        residual[v] = force_[v] + masses_[v] * inertia * (free - start[v] - total[v]);
    }
    for (const ConstraintPull& pull : pulls_) {
        const double damping = (scaleOf(settings_).damped - 1) * pull.stiffness;
        double change = 0;
        for (int k = 0; k < pull.count; ++k) {
            change += pull.gradients[k].dot(total[pull.vertices[k]]);
        }
        for (int k = 0; k < pull.count; ++k) {
            residual[pull.vertices[k]] -= damping * change * pull.gradients[k];
        }
    }
    return residual;
}

std::vector<double> ImplicitReference::missingVolumes() const {
    std::vector<double> missing(volume_.size());
    for (std::size_t p = 0; p < missing.size(); ++p) {
        missing[p] = model_.pieces[p].restVolume - volume_[p];
    }
    return missing;
}

Vectors ImplicitReference::solveStage(const StageStart& from, const Vectors& start,
                                      ContactRows& rows, ImplicitReport& report) {
    Vectors total(start.size(), Vec3::Zero());
    for (int pass = 0; pass < settings_.passes; ++pass) {
        if (settings_.passes > 1) {
            linearise(sumOf(start, 1, total));
        }
        ContactRows moved = rows;  // to where the body is linearised
        for (ContactRow& row : moved) {
            row.gap += row.normal.dot(row.relative(total));
            row.slip += row.across(row.relative(total));
        }
        Descent descent(*this, residualAt(total, start, from), moved);
        if (settings_.holdsVolume) {
            descent.addVolume(missingVolumes());
        }
        if (pass == 0) {
            const Vectors free = sumOf(from.positions, scaleOf(settings_).stage, from.velocities);
            descent.goAlong(sumOf(free, -1, start));
        }
        report.residual = descent.iterate(settings_.iterations, settings_.tolerance);
        descent.balance();
        descent.finish(report);
        total = sumOf(total, 1, descent.displacement());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].push = moved[k].push;
        }
    }
    return total;
}

/// Gives what nothing outside holds the angular momentum that the forces on it say.
void ImplicitReference::spinBack(const ReferenceState& before, const ContactRows& rows,
                                 ReferenceState& state) const {
    UnionFind joined(model_.pieces.size());
    std::vector<Turning> turnings(model_.pieces.size());
    const auto pieceOf = [&](std::size_t v) { return model_.pieceOfVertex[v]; };
    for (const ContactRow& row : rows) {
        for (int k = 1; k < row.count; ++k) {
            joined.join(pieceOf(row.vertices[0]), pieceOf(row.vertices[k]));
        }
    }
    for (const ContactRow& row : rows) {
        turnings[joined.root(pieceOf(row.vertices[0]))].isFree &= row.count > 1;
    }
    for (std::size_t v = 0; v < masses_.size(); ++v) {
        if (pieceOf(v) >= 0) {
            const Vec3 speed = before.velocities[v];
            const Vec3 given = masses_[v] * speed + settings_.step * force_[v];
            turnings[joined.root(pieceOf(v))].add(masses_[v], {before.positions[v], speed, given},
                                                  {state.positions[v], state.velocities[v], {}});
        }
    }
    const double kept = std::exp(-settings_.drag * settings_.step);
    for (std::size_t v = 0; v < masses_.size(); ++v) {
        if (pieceOf(v) >= 0 && turnings[joined.root(pieceOf(v))].isFree) {
            state.velocities[v] +=
                turnings[joined.root(pieceOf(v))].changeAt(state.positions[v], kept);
        }
    }
}

ContactRows ImplicitReference::findRows(const ReferenceState& state) {
    if (finder_ == nullptr) {
        return {};
    }
    ContactRows rows = finder_->find(state, settings_.step);
    const double rate = contactRate(settings_.step);
    for (ContactRow& row : rows) {
        double yielding = 0;
        double point = 0;
        for (int k = 0; k < row.count; ++k) {
            const std::uint32_t v = row.vertices[k];
            const double firm = firmness_[v] + rate * rate * masses_[v];
            (row.weights[k] > 0 ? point : yielding) += std::fabs(row.weights[k]) * firm;
        }
        row.stiffness = row.count == 1 ? point : 2 * point * yielding / (point + yielding);
        const auto held = std::ranges::lower_bound(held_, row.memory, {}, &Held::memory);
        if (held != held_.end() && held->memory == row.memory) {
            row.slip = row.across(held->slip);
            row.push = held->push;
        }
        const double pressed = row.push / row.stiffness + shared::kLetOut * std::max(0.0, -row.gap);
        row.gap = std::max(row.gap, -pressed);
    }
    return rows;
}

void ImplicitReference::keepSlips(const ContactRows& rows) {
    held_.clear();
    for (const ContactRow& row : rows) {
        if (row.push > 0) {
            held_.push_back(
                {row.memory,
                 gripOf(row, row.slip, row.friction * row.push) / row.stiffness * row.slip,
                 row.push});
        }
    }
    std::ranges::sort(held_, {}, &Held::memory);
}

ImplicitReport ImplicitReference::step(ReferenceState& state) {
    const double s = scaleOf(settings_).stage;
    const double rest = settings_.step - s;
    ImplicitReport report;
    ContactRows rows = findRows(state);
    const ReferenceState before = state;
    const Vectors& start = before.positions;
    StageStart from{start, state.velocities};
    linearise(start);
    const Vectors first = solveStage(from, start, rows, report);
    for (std::size_t v = 0; v < start.size(); ++v) {
        const Vec3 speed = first[v] / s;
        from.velocities[v] += rest / s * (speed - from.velocities[v]);
        from.positions[v] += rest * speed;
    }
    for (ContactRow& row : rows) {
        const double led = row.gap + rest / s * row.normal.dot(row.relative(first));
        row.from = row.push > 0 ? std::max(led, 0.0) : shared::kUndamped;
    }
    const Vectors second = solveStage(from, start, rows, report);
    const double kept = std::exp(-settings_.drag * settings_.step);
    for (std::size_t v = 0; v < start.size(); ++v) {
        if (masses_[v] > 0) {
            state.positions[v] = start[v] + second[v];
            state.velocities[v] = kept / s * (state.positions[v] - from.positions[v]);
        }
    }
    spinBack(before, rows, state);
    for (ContactRow& row : rows) {
        row.slip += row.across(row.relative(second));
    }
    keepSlips(rows);
    return report;
}

}  // namespace kerf
