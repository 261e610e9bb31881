#include "ui/plots/plot_math.h"

#include <spdlog/fmt/fmt.h>

namespace kerf::ui {

namespace {

SeriesBucket merged(const SeriesBucket& a, const SeriesBucket& b) {
    const int count = a.count + b.count;
    return {a.x, std::min(a.low, b.low), std::max(a.high, b.high),
            (a.mean * a.count + b.mean * b.count) / count, count};
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `raw`.
double roundStepUp(double raw) {
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        // A relative slack, so that a raw step of 0.2 stays 0.2.
        if (factor * power >= raw * (1 - 1e-9)) {
            return factor * power;
        }
    }
    return 10 * power;
}

}  // namespace

void Series::add(double x, double y) {
    if (!std::isfinite(y)) {
        return;
    }
    last_ = y;
    const SeriesBucket value{x, y, y, y, 1};
    count(value);
    if (!buckets_.empty() && buckets_.back().count < perBucket_) {
        buckets_.back() = merged(buckets_.back(), value);
        return;
    }
    if (buckets_.size() == kMostBuckets) {
        mergeNeighbours();
    }
    buckets_.push_back(value);
}

void Series::forgetAfter(double x) {
    const auto isLater = [x](const SeriesBucket& bucket) { return bucket.x > x; };
    buckets_.erase(std::ranges::find_if(buckets_, isLater), buckets_.end());
    last_ = buckets_.empty() ? 0 : buckets_.back().mean;
    sum_ = min_ = max_ = count_ = 0;
    for (const SeriesBucket& bucket : buckets_) {
        count(bucket);
    }
}

void Series::count(const SeriesBucket& bucket) {
    min_ = count_ > 0 ? std::min(min_, bucket.low) : bucket.low;
    max_ = count_ > 0 ? std::max(max_, bucket.high) : bucket.high;
    sum_ += bucket.mean * bucket.count;
    count_ += bucket.count;
}

void Series::mergeNeighbours() {
    for (std::size_t i = 0; i < buckets_.size() / 2; ++i) {
        buckets_[i] = merged(buckets_[2 * i], buckets_[2 * i + 1]);
    }
    buckets_.resize(buckets_.size() / 2);
    perBucket_ *= 2;
}

PlotTicks niceTicks(const PlotRange& range, int maxCount) {
    PlotTicks ticks;
    if (!(range.span() > 0) || !std::isfinite(range.span())) {
        return ticks;
    }
    const double step = roundStepUp(range.span() / std::max(1, maxCount - 1));
    const double slack = 1e-9 * step;
    const double first = std::ceil((range.low - slack) / step);
    const double last = std::floor((range.high + slack) / step);
    for (double k = first; k <= last; ++k) {
        ticks.values.push_back(k * step + 0.0);  // never "-0"
    }
    ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return ticks;
}

PlotRange paddedRange(const PlotRange& range, double minSpan) {
    if (range.low > range.high) {
        return {0, minSpan};
    }
    const double middle = 0.5 * (range.low + range.high);
    const double half = 0.5 * std::max(1.1 * range.span(), minSpan);
    return {middle - half, middle + half};
}

std::span<const SeriesBucket> bucketsIn(std::span<const SeriesBucket> buckets, const PlotRange& x) {
    auto first = std::ranges::lower_bound(buckets, x.low, {}, &SeriesBucket::x);
    const auto end = std::ranges::upper_bound(buckets, x.high, {}, &SeriesBucket::x);
    if (first != buckets.begin() && first != end) {
        --first;
    }
    return {first, std::max(first, end)};
}

PlotRange valueRange(std::span<const SeriesBucket> buckets) {
    PlotRange range{1e300, -1e300};
    for (const SeriesBucket& bucket : buckets) {
        range.low = std::min(range.low, bucket.low);
        range.high = std::max(range.high, bucket.high);
    }
    return range;
}

PlotRange rangeOf(const PlotView& view, double newest) {
    constexpr double kShortest = 1;
    const double end = view.end.value_or(newest);
    if (view.span > 0) {
        return {end - view.span, end};
    }
    return {0, std::max(kShortest, end)};
}

PlotView zoomed(const PlotView& view, double newest, double notches, double at, bool following) {
    constexpr double kFactor = 0.8;
    constexpr double kClosest = 0.02;  // [s]
    const PlotRange now = rangeOf(view, newest);
    const double whole = std::max(newest, kClosest);
    const double span = std::clamp(now.span() * std::pow(kFactor, notches), kClosest, whole);
    const double share = (at - now.low) / now.span();
    return following && !view.end ? PlotView{span >= whole ? 0 : span, {}}
                                  : panned({span, at + (1 - share) * span}, newest, 0);
}

PlotView panned(const PlotView& view, double newest, double by) {
    const PlotRange now = rangeOf(view, newest);
    if (now.span() >= newest) {
        return {};  // all is in sight
    }
    const double end = std::clamp(now.high + by, now.span(), newest);
    return {now.span(), end < newest ? std::optional(end) : std::nullopt};
}

std::vector<PlotColumn> gatherColumns(std::span<const SeriesBucket> buckets, const PlotRange& x,
                                      int columns) {
    std::vector<PlotColumn> out;
    int count = 0;
    for (const SeriesBucket& bucket : bucketsIn(buckets, x)) {
        if (bucket.x < x.low) {
            continue;
        }
        const double share = x.span() > 0 ? (bucket.x - x.low) / x.span() : 0;
        const int column = std::min(columns - 1, static_cast<int>(share * columns));
        if (out.empty() || out.back().column != column) {
            out.push_back({column, bucket.low, bucket.high, bucket.mean});
            count = bucket.count;
            continue;
        }
        PlotColumn& last = out.back();
        last.low = std::min(last.low, bucket.low);
        last.high = std::max(last.high, bucket.high);
        count += bucket.count;
        last.mean += (bucket.mean - last.mean) * bucket.count / count;
    }
    return out;
}

const SeriesBucket& nearestBucket(std::span<const SeriesBucket> buckets, double x) {
    const auto after = std::ranges::lower_bound(buckets, x, {}, &SeriesBucket::x);
    if (after == buckets.begin()) {
        return buckets.front();
    }
    if (after == buckets.end()) {
        return buckets.back();
    }
    const auto before = after - 1;
    return x - before->x < after->x - x ? *before : *after;
}

std::string fixedText(double value, int decimals) {
    return fmt::format("{:.{}f}", value, decimals);
}

std::string numberText(double value, int decimals) {
    constexpr double kLarge = 1e6;
    constexpr int kLong = 5;  // decimals
    const double size = std::abs(value);
    const bool vanishes = size < 0.5 * std::pow(10, -decimals);
    if (value == 0 || (size < 1 ? decimals <= kLong && !vanishes : size < kLarge)) {
        return fixedText(value, value == 0 && decimals > kLong ? 0 : decimals);
    }
    return fmt::format("{:.4g}", value);
}

}  // namespace kerf::ui
