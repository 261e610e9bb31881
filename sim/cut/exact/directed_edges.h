#pragma once

#include <vector>

namespace kerf::cut {

/// Numbers by directed edges between ends from 0 on, of which few leave one end.
class DirectedEdges {
  public:
    explicit DirectedEdges(std::size_t ends) : first_(ends, -1) {}

    /// False where the edge has a number already, which it keeps. `value` >= 0.
    bool add(int from, int to, int value) {
        if (find(from, to) >= 0) {
            return false;
        }
        entries_.push_back({to, value, first_[from]});
        first_[from] = static_cast<int>(entries_.size()) - 1;
        return true;
    }
    /// -1 where there is none, also from ends that do not exist.
    int find(int from, int to) const {
        int entry = from < static_cast<int>(first_.size()) ? first_[from] : -1;
        while (entry >= 0 && entries_[entry].to != to) {
            entry = entries_[entry].next;
        }
        return entry < 0 ? -1 : entries_[entry].value;
    }
    bool has(int from, int to) const { return find(from, to) >= 0; }
    void reserve(std::size_t edges) { entries_.reserve(edges); }

  private:
    struct Entry {
        int to;
        int value;
        int next;  ///< from the same end, -1 for none
    };
    std::vector<int> first_;
    std::vector<Entry> entries_;
};

}  // namespace kerf::cut
