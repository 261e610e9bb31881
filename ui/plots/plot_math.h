#pragma once

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

/// A value y at x.
struct PlotPoint {
    double x = 0;
    double y = 0;
};

/// An event at x.
struct PlotMark {
    double x = 0;
    std::string label;
};

/// The part of an axis that is shown.
struct PlotRange {
    double low = 0;
    double high = 1;
    double span() const { return high - low; }
    bool operator==(const PlotRange&) const = default;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) inside the range, at most `maxCount` (at
/// least 2), rising. `decimals`: enough to distinguish neighbours.
struct PlotTicks {
    std::vector<double> values;
    int decimals = 0;
};
/// Ticks at round numbers for an axis that shows `range`, at most `maxCount` of them.
PlotTicks niceTicks(const PlotRange& range, int maxCount);

/// The range with a margin of a twentieth at both ends, opened about its middle to at least
/// `minSpan`; {0, minSpan} for an inverted one.
PlotRange paddedRange(const PlotRange& range, double minSpan);

/// The buckets that begin in the range, and the one before.
std::span<const SeriesBucket> bucketsIn(std::span<const SeriesBucket> buckets, const PlotRange& x);
/// Lowest and highest value of the buckets; inverted without buckets.
PlotRange valueRange(std::span<const SeriesBucket> buckets);

/// The part of the time axis that all plots show.
struct PlotView {
    double span = 0;            ///< [s]; 0: all since the start
    std::optional<double> end;  ///< [s]; none: the newest, so that the plots follow
    bool operator==(const PlotView&) const = default;
};
/// The range of a view where the newest value is at `newest`; never shorter than a second where all
/// is shown.
PlotRange rangeOf(const PlotView& view, double newest);
/// The view after `notches` of the wheel (> 0: closer), with the time `at` staying in its place,
/// or, where `following`, the newest one.
PlotView zoomed(const PlotView& view, double newest, double notches, double at, bool following);
/// The view moved by so much time [s], within the run.
PlotView panned(const PlotView& view, double newest, double by);

/// Lowest, highest and mean value of one column of pixels.
struct PlotColumn {
    int column = 0;
    double low = 0;
    double high = 0;
    double mean = 0;
};
/// Buckets (by rising x) gathered into `columns` equal columns of `x`; empty ones are left out, as
/// are buckets outside.
std::vector<PlotColumn> gatherColumns(std::span<const SeriesBucket> buckets, const PlotRange& x,
                                      int columns);

/// The bucket that begins nearest to `x`, of at least one.
const SeriesBucket& nearestBucket(std::span<const SeriesBucket> buckets, double x);

/// A number with so many decimals.
std::string fixedText(double value, int decimals);
/// fixedText(), or four digits and a power of ten where that would be long, or 0 alone.
std::string numberText(double value, int decimals);

}  // namespace kerf::ui
