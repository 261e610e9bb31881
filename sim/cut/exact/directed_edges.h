#pragma once

#include <vector>

namespace kerf::cut {

/// A table of numbers by directed edges between ends 0, 1, ...; few edges leave one end.
class DirectedEdges {
  public:
    /// An empty table for edges between ends below `ends`.
    explicit DirectedEdges(std::size_t ends) : first_(ends, -1) {}

    /// Gives an edge the number `value` >= 0. Returns false if it has one already, which it keeps.
    bool add(int from, int to, int value) {
        if (find(from, to) >= 0) {
            return false;
        }
        entries_.push_back({to, value, first_[from]});
        first_[from] = static_cast<int>(entries_.size()) - 1;
        return true;
    }
    /// The number of an edge, -1 for none or for ends that do not exist.
    int find(int from, int to) const {
        int entry = from < static_cast<int>(first_.size()) ? first_[from] : -1;
        while (entry >= 0 && entries_[entry].to != to) {
            entry = entries_[entry].next;
        }
        return entry < 0 ? -1 : entries_[entry].value;
    }
    /// Whether the edge has a number.
    bool has(int from, int to) const { return find(from, to) >= 0; }
    /// Makes room for `edges` edges.
    void reserve(std::size_t edges) { entries_.reserve(edges); }

  private:
    struct Entry {
        int to;
        int value;
        int next;  ///< the next entry from the same end, -1 for none
    };
    std::vector<int> first_;
    std::vector<Entry> entries_;
};

}  // namespace kerf::cut
