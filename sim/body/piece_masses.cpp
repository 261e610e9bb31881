#include "sim/body/piece_masses.h"

namespace kerf {

namespace {

constexpr double kMassFloor = 0.05;    // of the mean vertex area of the piece
constexpr double kLeastVolume = 1e-9;  // of the uncut body: chips may have none
constexpr int kBinsPerOctave = 4;
constexpr int kLowestExponent = -70;  // 2^-70 m^2: a millionth of a hair squared
// 2^(k/4 - 1): where frexp's mantissas cross from a bin to the next.
constexpr std::array<double, 4> kMantissas{0.5, 0.5946035575013605, 0.7071067811865476,
                                           0.8408964152537145};

}  // namespace

int VertexAreas::binOf(double area) {
    if (!(area > 0)) {
        return 0;
    }
    int exponent = 0;
    const double mantissa = std::frexp(area, &exponent);
    const auto above = std::upper_bound(kMantissas.begin(), kMantissas.end(), mantissa);
    const int quarter = static_cast<int>(above - kMantissas.begin()) - 1;
    return std::clamp((exponent - kLowestExponent) * kBinsPerOctave + quarter, 0, kBins - 1);
}

double VertexAreas::lowerEdge(int bin) {
    return std::ldexp(kMantissas[bin % kBinsPerOctave], bin / kBinsPerOctave + kLowestExponent);
}

void VertexAreas::add(double area) {
    Bin& bin = bins_[binOf(area)];
    ++bin.count;
    bin.sum += area;
}

void VertexAreas::remove(double area) {
    Bin& bin = bins_[binOf(area)];
    --bin.count;
    bin.sum = bin.count == 0 ? 0.0 : bin.sum - area;
}

int VertexAreas::count() const {
    int sum = 0;
    for (const Bin& bin : bins_) {
        sum += bin.count;
    }
    return sum;
}

// The least area is the next edge of a bin, so that whole bins lie above or below it.
void VertexAreas::setMasses(PieceModel& piece, double uncutRestVolume) const {
    const double mean = piece.restArea / std::max(1u, piece.vertexCount);
    const int floor = std::min(kBins - 1, binOf(kMassFloor * mean) + 1);
    piece.leastArea = lowerEdge(floor);
    double sum = 0;
    for (int bin = 0; bin < kBins; ++bin) {
        sum += bin < floor ? bins_[bin].count * piece.leastArea : bins_[bin].sum;
    }
    const double volume = std::max(piece.restVolume, kLeastVolume * uncutRestVolume);
    piece.massPerArea = sum > 0 ? volume / sum : 0.0;
}

double unitMass(const BodyModel& model, std::size_t vertex) {
    const int piece = model.pieceOfVertex[vertex];
    if (piece < 0) {
        return 0;
    }
    const PieceModel& p = model.pieces[piece];
    return p.massPerArea * std::max(model.vertexAreas[vertex], p.leastArea);
}

std::vector<double> unitMasses(const BodyModel& model) {
    std::vector<double> masses;
    masses.reserve(model.pieceOfVertex.size());
    for (std::size_t v = 0; v < model.pieceOfVertex.size(); ++v) {
        masses.push_back(unitMass(model, v));
    }
    return masses;
}

}  // namespace kerf
