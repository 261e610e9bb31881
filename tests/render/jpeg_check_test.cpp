// JPEG files that were made to harm their decoder.
#include "render/scene/jpeg_check.h"

#include <gmock/gmock.h>

#include "render/scene/appearance.h"

namespace kerf::render {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string kBegin = "\xff\xd8\xff\xe0" + std::string("\0\4ab", 4);

constexpr char kAlternating = 16;  // the kind of a table: of alternating coefficients, number 0

/// A segment of a table with so many codes of each length from 1 to 16 bits.
std::string tableOf(unsigned char codes, char kind = 0) {
    const int size = 2 + 17 + 16 * codes;
    std::string segment = "\xff\xc4";
    segment += static_cast<char>(size >> 8);
    segment += static_cast<char>(size & 0xff);
    return segment + kind + std::string(16, static_cast<char>(codes)) +
           std::string(16 * static_cast<std::size_t>(codes), 'v');
}

/// The head of a scan and some of its data, with a byte that looks like a marker and is none.
const std::string kScanOfOne =
    "\xff\xda" + std::string("\0\x08\1\1\0\0\x3f\0", 8) + std::string("ab\xff\0\xff\xd0yz", 8);

/// The tables that it asks for.
const std::string kItsTables = tableOf(1) + tableOf(1, kAlternating);

TEST(JpegCheck, TablesHaveAtMostTheCodesThatThereCanBe) {
    EXPECT_EQ(faultOfJpeg(kBegin + tableOf(15)), "");
    EXPECT_EQ(faultOfJpeg(kBegin + tableOf(16)), "its tables are damaged or missing");
    EXPECT_EQ(faultOfJpeg(kBegin + tableOf(3) + tableOf(255)), "its tables are damaged or missing");
}

TEST(JpegCheck, TablesBehindAScanAreLookedAt) {
    EXPECT_EQ(faultOfJpeg(kBegin + kItsTables + kScanOfOne + tableOf(15)), "");
    EXPECT_EQ(faultOfJpeg(kBegin + kItsTables + kScanOfOne + tableOf(17)),
              "its tables are damaged or missing");
    EXPECT_EQ(faultOfJpeg(kBegin + kItsTables + kScanOfOne + "\xff\xff" + tableOf(17)),
              "its tables are damaged or missing");
}

// The decoder would take what happens to lie in its memory.
TEST(JpegCheck, AScanHasTheTablesThatItAsksFor) {
    const std::string missing = "its tables are damaged or missing";
    EXPECT_EQ(faultOfJpeg(kBegin + kItsTables + kScanOfOne), "");
    EXPECT_EQ(faultOfJpeg(kBegin + kScanOfOne), missing);
    EXPECT_EQ(faultOfJpeg(kBegin + tableOf(1) + kScanOfOne), missing);
    EXPECT_EQ(faultOfJpeg(kBegin + tableOf(1, kAlternating) + kScanOfOne), missing);
    const std::string frame = "\xff\xc0" + std::string("\0\x0b\x08\0\x09\0\x09\1\1\x11\2", 11);
    const std::string quantities = "\xff\xdb" + std::string("\0\x43\2", 3) + std::string(64, 'q');
    EXPECT_EQ(faultOfJpeg(kBegin + frame + kItsTables + kScanOfOne), missing);
    EXPECT_EQ(faultOfJpeg(kBegin + quantities + frame + kItsTables + kScanOfOne), "");
}

TEST(JpegCheck, WhatOtherSegmentsHoldIsNoTable) {
    const std::string table = tableOf(17);
    std::string other = "\xff\xe1";
    other += static_cast<char>((table.size() + 2) >> 8);
    other += static_cast<char>((table.size() + 2) & 0xff);
    EXPECT_EQ(faultOfJpeg(kBegin + other + table), "");
}

TEST(JpegCheck, ScansHaveAnEnd) {
    std::string scans = kItsTables;
    for (int i = 0; i < kMostScans; ++i) {
        scans += kScanOfOne;
    }
    EXPECT_EQ(faultOfJpeg(kBegin + scans), "");
    EXPECT_THAT(faultOfJpeg(kBegin + scans + kScanOfOne), HasSubstr("more than 100 scans"));
}

TEST(JpegCheck, CutOffAnywhereItIsReadToItsEnd) {
    const std::string whole = kBegin + kItsTables + kScanOfOne + tableOf(17);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string fault = faultOfJpeg(whole.substr(0, size));
        EXPECT_TRUE(fault.empty() || size > whole.size() - tableOf(17).size()) << size;
    }
}

TEST(JpegCheck, ComesBeforeAnythingElseReadsTheFile) {
    EXPECT_THAT([] { sizeOfImage(kBegin + tableOf(17)); },
                ThrowsMessage<std::runtime_error>(HasSubstr("its tables are damaged")));
}

}  // namespace
}  // namespace kerf::render
