#pragma once

#include <bit>

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

/// A table of numbers of some of the vertices of a mesh.
class VertexNumbers {
  public:
    /// An empty table with room for `most` vertices.
    explicit VertexNumbers(std::size_t most = 8) : slots_(std::bit_ceil(2 * most + 1)) {}

    /// The number of a vertex, -1 where it has none.
    int find(int vertex) const { return slots_[slotFor(vertex)].number; }
    /// Gives a vertex that has none the number `number` >= 0.
    void add(int vertex, int number) {
        if (2 * ++count_ > slots_.size()) {
            grow();
        }
        slots_[slotFor(vertex)] = {vertex, number};
    }
    /// How many vertices have a number.
    std::size_t size() const { return count_; }

  private:
    struct Slot {
        int vertex = -1;
        int number = -1;
    };

    /// The slot where the vertex is, or where it would go.
    std::size_t slotFor(int vertex) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = static_cast<std::uint64_t>(vertex) * 0x9E3779B97F4A7C15ull >> 32 & mask;
        while (slots_[at].vertex >= 0 && slots_[at].vertex != vertex) {
            at = (at + 1) & mask;
        }
        return at;
    }

    void grow() {
        const std::vector<Slot> before =
            std::exchange(slots_, std::vector<Slot>(4 * slots_.size()));
        for (const Slot& slot : before) {
            if (slot.vertex >= 0) {
                slots_[slotFor(slot.vertex)] = slot;
            }
        }
    }

    std::vector<Slot> slots_;  ///< a power of two of them, half empty at least
    std::size_t count_ = 0;
};

}  // namespace kerf::cut
