#pragma once

namespace kerf::app {

/// Tracks the part of a list that has changed since the last call: between the unchanged items at
/// both ends.
class ChangedPart {
  public:
    /// A change of a list: `dropped` items from `at` on are replaced by `added` new items.
    struct Splice {
        std::size_t at = 0;
        std::size_t dropped = 0;
        std::size_t added = 0;
        bool empty() const { return dropped == 0 && added == 0; }
    };

    /// Items from `begin` to before `end` are new or changed, or some were removed there; the list
    /// has `size` items now.
    void touch(std::size_t begin, std::size_t end, std::size_t size) {
        head_ = std::min(head_, begin);
        tail_ = std::min(tail_, size - end);
    }
    /// What has changed since the last call, in a list of `size` items now; `whole`: all of it.
    Splice take(std::size_t size, bool whole) {
        if (whole) {
            *this = {};
            size_ = size;
            return {0, 0, size};
        }
        const std::size_t before = size_;
        const bool same = head_ == kNone;
        const Splice splice =
            same ? Splice{size, 0, 0} : Splice{head_, before - head_ - tail_, size - head_ - tail_};
        *this = {};
        size_ = size;
        return splice;
    }

  private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    std::size_t size_ = 0;      ///< of the list at the last call
    std::size_t head_ = kNone;  ///< items before it have stayed
    std::size_t tail_ = kNone;  ///< number of items at the end that have stayed
};

}  // namespace kerf::app
