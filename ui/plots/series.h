#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kerf::ui {

/// Values of neighbouring x: lowest, highest and mean.
struct SeriesBucket {
    double x = 0;  ///< of the first one
    double low = 0;
    double high = 0;
    double mean = 0;
    int count = 0;
};

/// Values over a rising x, in a bounded number of buckets: at first a bucket holds one value; then
/// neighbours are merged repeatedly, keeping extremes. So hours cost no more memory and time than
/// minutes.
class Series {
  public:
    static constexpr std::size_t kMostBuckets = 16384;

    /// Adds a value at an `x` that is not below the previous one. Ignores values that are not
    /// finite.
    void add(double x, double y);
    /// Drops the buckets that begin after `x`.
    void forgetAfter(double x);

    bool empty() const { return buckets_.empty(); }
    std::span<const SeriesBucket> buckets() const { return buckets_; }
    /// The newest value; 0 while empty.
    double last() const { return last_; }
    /// The mean of all values; 0 while empty.
    double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
    double sum() const { return sum_; }
    /// The lowest value; 0 while empty.
    double min() const { return min_; }
    /// The highest value; 0 while empty.
    double max() const { return max_; }

  private:
    void count(const SeriesBucket& bucket);
    void mergeNeighbours();

    std::vector<SeriesBucket> buckets_;
    int perBucket_ = 1;
    double last_ = 0;
    double sum_ = 0;
    double min_ = 0;
    double max_ = 0;
    double count_ = 0;
};

}  // namespace kerf::ui
