#pragma once

#include "sim/body/body_model.h"

namespace kerf {

/// The rest areas of the vertices of a piece, summed so that the masses of all of them follow from
/// two numbers, which a cut changes at the cost of the vertices that it touched.
class VertexAreas {
  public:
    void add(double area);
    void remove(double area);
    /// How many vertices the piece has.
    int count() const;

    /// Sets the mass of the piece so that unitMass() sums to its rest volume: cutting keeps the
    /// mass. A vertex has at least about 5 % of the mean mass of its piece: lighter ones are thrown
    /// about by slivers. `uncutRestVolume` [m^3].
    void setMasses(PieceModel& piece, double uncutRestVolume) const;

  private:
    // A quarter of an octave each; what lies beyond the ends counts to the first and last one.
    static constexpr int kBins = 320;
    static int binOf(double area);
    static double lowerEdge(int bin);

    struct Bin {
        int count = 0;
        double sum = 0;  ///< [m^2]
    };
    std::array<Bin, kBins> bins_{};
};

/// Mass at density 1 of a vertex [m^3]: massPerArea * max(area, leastArea) of its piece; 0 for
/// unused vertices. Multiply by the density for kg.
double unitMass(const BodyModel& model, std::size_t vertex);
/// The masses at density 1 of all vertices [m^3]: see unitMass().
std::vector<double> unitMasses(const BodyModel& model);

}  // namespace kerf
