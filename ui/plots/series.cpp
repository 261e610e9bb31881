#include "ui/plots/series.h"

#include <algorithm>
#include <cmath>

namespace kerf::ui {
namespace {

SeriesBucket merged(const SeriesBucket& a, const SeriesBucket& b) {
    const int count = a.count + b.count;
    return {a.x, std::min(a.low, b.low), std::max(a.high, b.high),
            (a.mean * a.count + b.mean * b.count) / count, count};
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

}  // namespace kerf::ui
