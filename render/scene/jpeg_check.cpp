#include "render/scene/jpeg_check.h"

#include <algorithm>
#include <array>
#include <set>

namespace kerf::render {
namespace {

// Markers: ITU T.81, table B.1.
constexpr int kCodeTables = 0xc4;
constexpr int kProgressive = 0xc2;
constexpr int kLastFrame = 0xc2;  // of those that stb_image reads
constexpr int kScan = 0xda;
constexpr int kQuantities = 0xdb;

constexpr int kLengths = 16;  // of codes [bits]
// There can be 256, but the decoder takes the last of so many for none; encoders make 162 at most.
constexpr int kMostCodes = 255;

/// Walks through the bytes; behind the end stand zeros, as the decoder has it.
class Walk {
  public:
    explicit Walk(std::string_view bytes) : bytes_(bytes) {}

    bool atEnd() const { return at_ >= bytes_.size(); }
    int byte() { return atEnd() ? 0 : static_cast<unsigned char>(bytes_[at_++]); }
    int length() {
        const int high = byte();
        return 256 * high + byte() - 2;  // It counts itself.
    }
    void skip(int count) {
        at_ += std::min(bytes_.size() - at_, static_cast<std::size_t>(std::max(count, 0)));
    }
    /// The next marker; in the data of a scan a zero behind 0xff means none. 0 at the end.
    int marker() {
        for (at_ = bytes_.find('\xff', at_); !atEnd(); at_ = bytes_.find('\xff', at_)) {
            int marker = byte();
            while (marker == 0xff) {
                marker = byte();
            }
            if (marker != 0) {
                return marker;
            }
        }
        return 0;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// The tables that were defined so far. The decoder does not look whether those are there that a
/// scan asks for, and takes what happens to lie in its memory.
class Tables {
  public:
    /// Takes the code tables of a segment. Returns false where the decoder can't hold them.
    bool takeCodes(Walk& walk) {
        for (int left = walk.length(); left > 0;) {
            const int table = walk.byte();
            int codes = 0;
            for (int i = 0; i < kLengths; ++i) {
                codes += walk.byte();
            }
            if (codes > kMostCodes) {
                return false;
            }
            codes_.insert(table);
            walk.skip(codes);
            left -= 1 + kLengths + codes;
        }
        return true;
    }
    void takeQuantities(Walk& walk) {
        constexpr int kCount = 64;
        for (int left = walk.length(); left > 0;) {
            const int table = walk.byte();
            const int bytes = table / 16 == 0 ? kCount : 2 * kCount;
            quantities_.insert(table % 16);
            walk.skip(bytes);
            left -= 1 + bytes;
        }
    }
    void takeFrame(Walk& walk, int marker) {
        constexpr int kBeforeCount = 5;  // precision, height and width
        progressive_ = marker == kProgressive;
        int left = walk.length() - kBeforeCount - 1;
        walk.skip(kBeforeCount);
        walk.byte();  // the number of components, which the length tells too
        for (; left > 0; left -= 3) {
            walk.skip(2);  // its name and how it is sampled
            asked_.insert(walk.byte());
        }
    }
    /// Takes the head of a scan. Returns whether all tables are there that it asks for.
    bool takeScan(Walk& walk) {
        int left = walk.length() - 1;
        std::set<int> components;
        for (int count = walk.byte(); count > 0 && left > 0; --count, left -= 2) {
            walk.byte();  // its name
            components.insert(walk.byte());
        }
        const int first = walk.byte();  // coefficient
        walk.skip(left - 1);
        const bool direct = !progressive_ || first == 0;
        const bool alternating = !progressive_ || first > 0;
        const auto hasCodes = [&](int component) {
            constexpr int kAlternating = 16;
            return (!direct || codes_.contains(component / 16)) &&
                   (!alternating || codes_.contains(kAlternating + component % 16));
        };
        return std::ranges::all_of(components, hasCodes) &&
               std::ranges::includes(quantities_, asked_);
    }

  private:
    bool progressive_ = false;
    std::set<int> codes_;       ///< 16 for those of alternating coefficients, plus the number
    std::set<int> quantities_;  ///< by number
    std::set<int> asked_;       ///< quantities that components are scaled by
};

/// Whether a segment with a length follows.
bool hasLength(int marker) {
    return marker >= 0xc0 && (marker < 0xd0 || marker >= kScan);
}

bool isFrame(int marker) {
    return marker >= 0xc0 && marker <= kLastFrame;
}

/// Goes over the segment behind a marker. Returns whether the decoder may see it.
bool isSound(int marker, Tables& tables, Walk& walk) {
    if (marker == kCodeTables) {
        return tables.takeCodes(walk);
    }
    if (marker == kScan) {
        return tables.takeScan(walk);
    }
    if (marker == kQuantities) {
        tables.takeQuantities(walk);
    } else if (isFrame(marker)) {
        tables.takeFrame(walk, marker);
    } else if (hasLength(marker)) {
        walk.skip(walk.length());
    }
    return true;
}

}  // namespace

std::string faultOfJpeg(std::string_view jpeg) {
    Walk walk(jpeg);
    Tables tables;
    int scans = 0;
    for (int marker = walk.marker(); marker != 0; marker = walk.marker()) {
        if (!isSound(marker, tables, walk)) {
            return "its tables are damaged or missing";
        }
        scans += marker == kScan ? 1 : 0;
    }
    return scans <= kMostScans
               ? ""
               : "it has more than " + std::to_string(kMostScans) + " scans, so it is damaged";
}

}  // namespace kerf::render
