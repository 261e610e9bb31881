#pragma once

#include <span>
#include <utility>
#include <vector>

#include "sim/cut/plan/slit_opening.h"

namespace kerf::cut {

/// What a stroke has made of its walls so long ago that they count as those of an older one: a
/// blade that comes round to where it started runs in their gap. Walls that the front has only just
/// made it may not meet.
class OwnPast {
  public:
    /// The front starts from the air; vertices from `firstVertex` on will be made.
    void start(int firstVertex);
    /// The front has come back into its own slit: all walls so far, up to `endVertex`, are past.
    void closeUp(int endVertex);
    /// The first walls have been made. They end, where the blade was put down, at these vertices.
    void begin(std::vector<int> startVertices) { start_ = std::move(startVertices); }
    /// The front goes on by `way`, as a share of the edge length. Vertices from `nextVertex` on are
    /// made then.
    void goOn(double way, int nextVertex);
    /// The vertices of walls that are past.
    const VertexRange& vertices() const { return past_; }
    /// The vertices where the first of these walls end, some of which may be dead. Empty before
    /// there are such walls.
    std::span<const int> startVertices() const {
        return past_.first < past_.end ? std::span<const int>(start_) : std::span<const int>();
    }

  private:
    /// The front before a step.
    struct Mark {
        double way;
        int nextVertex;
    };
    VertexRange past_;
    std::vector<int> start_;
    double way_ = 0;
    std::vector<Mark> recent_;  ///< of steps that are not past
};

}  // namespace kerf::cut
