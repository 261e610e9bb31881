#pragma once

#include "sim/base/containers.h"
#include "sim/body/body_model.h"

namespace kerf {

/// The room of the lists of an Incidence to grow, and its free blocks.
class IncidenceRooms {
  public:
    IncidenceRooms() = default;
    /// The rooms of an incidence as buildIncidence() makes it.
    explicit IncidenceRooms(const Incidence& incidence);

    /// Adds or removes an entry of a vertex; its entries stay ascending. A list without room left
    /// moves.
    void add(Incidence& incidence, std::uint32_t vertex, std::uint32_t entry);
    void remove(Incidence& incidence, std::uint32_t vertex, std::uint32_t entry);
    /// Makes `entries` the list of a vertex, in their order.
    void assign(Incidence& incidence, std::uint32_t vertex, std::span<const std::uint32_t> entries);
    /// Makes room for new vertices up to `vertexCount`.
    void resize(Incidence& incidence, std::size_t vertexCount);

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(room_, idle_);
    }

  private:
    void grow(Incidence& incidence, std::uint32_t vertex, std::uint32_t least);
    std::uint32_t takeBlock(Incidence& incidence, std::uint32_t room);
    std::vector<std::uint32_t>& idleBlocks(std::uint32_t room);

    std::vector<std::uint32_t> room_;               ///< by vertex
    std::vector<std::vector<std::uint32_t>> idle_;  ///< first entries of blocks, by room / 4
};

/// The changes of records and of the lists at vertices, ascending.
struct ListChange {
    std::vector<std::uint32_t> slots;     ///< of the records that were written
    std::vector<std::uint32_t> vertices;  ///< whose list changed
};

/// One edit of an array of records without gaps, and of the lists at vertices. Remove first, then
/// add, then close: new records fill the holes, and the last ones move into the remaining ones. So
/// few records move, and slots depend only on the history.
template <class Record>
class RecordEditor {
  public:
    RecordEditor(std::vector<Record>& records, Incidence& incidence, IncidenceRooms& rooms)
        : records_(records), incidence_(incidence), rooms_(rooms) {}

    void remove(int slot) {
        unlist(slot);
        holes_.push_back(slot);
        sorted_ = false;
    }

    /// Adds a record. Returns its slot.
    int add(const Record& record) {
        sortHoles();
        int slot = static_cast<int>(records_.size());
        if (filled_ < holes_.size()) {
            slot = holes_[filled_++];
            records_[slot] = record;
        } else {
            records_.push_back(record);
        }
        list(slot);
        return slot;
    }

    /// Calls moved(from, to) for each record that changes its slot.
    template <class Moved>
    void close(Moved&& moved) {
        sortHoles();
        std::size_t last = holes_.size();
        while (filled_ < last) {
            const int from = static_cast<int>(records_.size()) - 1;
            if (holes_[last - 1] == from) {
                --last;
            } else {
                unlist(from);
                const int to = holes_[filled_++];
                records_[to] = records_[from];
                list(to);
                moved(from, to);
            }
            records_.pop_back();
        }
        std::erase_if(change_.slots,
                      [this](std::uint32_t slot) { return slot >= records_.size(); });
        sortUnique(change_.slots);
        sortUnique(change_.vertices);
    }

    /// Changes a record in place; its vertices must stay.
    Record& rewrite(int slot) {
        change_.slots.push_back(static_cast<std::uint32_t>(slot));
        return records_[slot];
    }

    /// After close().
    ListChange takeChange() { return std::move(change_); }

  private:
    void sortHoles() {
        if (!sorted_) {
            std::sort(holes_.begin() + static_cast<std::ptrdiff_t>(filled_), holes_.end());
            sorted_ = true;
        }
    }
    void list(int slot) {
        change_.slots.push_back(static_cast<std::uint32_t>(slot));
        std::uint32_t entry = 4 * static_cast<std::uint32_t>(slot);
        for (const std::uint32_t v : verticesOf(records_[slot])) {
            rooms_.add(incidence_, v, entry++);
            change_.vertices.push_back(v);
        }
    }
    void unlist(int slot) {
        std::uint32_t entry = 4 * static_cast<std::uint32_t>(slot);
        for (const std::uint32_t v : verticesOf(records_[slot])) {
            rooms_.remove(incidence_, v, entry++);
            change_.vertices.push_back(v);
        }
    }

    std::vector<Record>& records_;
    Incidence& incidence_;
    IncidenceRooms& rooms_;
    std::vector<int> holes_;
    std::size_t filled_ = 0;
    bool sorted_ = true;
    ListChange change_;
};

}  // namespace kerf
