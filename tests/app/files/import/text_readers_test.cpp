// Models that are texts, and STL: what other programs write.
#include <gmock/gmock.h>

#include "app/files/import/face_soup.h"
#include "app/files/io/errors.h"
#include "app/files/io/text_lines.h"
#include "sim/repair/soup_inspection.h"
#include "tests/support/replaced_text.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using test::replaced;
using ::testing::HasSubstr;

class TextReaders : public ::testing::Test {
  protected:
    ImportedModel stl(const std::string& bytes) { return readStl(write("a.stl", bytes)); }
    ImportedModel off(const std::string& text) { return readOff(write("a.off", text)); }
    template <class Read>
    std::string sentence(Read read) {
        try {
            read();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    static void expectBox(const ImportedModel& model, const std::string& text) {
        const MeshReport report = inspectTriangles(weldExactly(model.soup));
        EXPECT_TRUE(report.cuttable) << report.problem << "\n" << text;
        EXPECT_NEAR(report.volume, 6, 1e-6) << text;
    }

  private:
    std::filesystem::path write(const std::string& name, const std::string& bytes) {
        test::writeText(folder_ / name, bytes);
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

std::string stlText() {
    const TriangleSoup box = test::boxSoup(Vec3(1, 2, 3));
    std::string text = "solid a box\n";
    for (const Triangle& triangle : box.triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const int v : triangle) {
            const Vec3& p = box.positions[v];
            text += "      vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                    std::to_string(p.z()) + "\n";
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid\n";
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// With `attribute` at each facet.
std::string stlBytes(const std::string& header, std::uint16_t attribute = 0) {
    const TriangleSoup box = test::boxSoup(Vec3(1, 2, 3));
    std::string bytes = header;
    bytes.resize(80, ' ');
    const auto append = [&](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(static_cast<std::uint32_t>(box.triangles.size()));
    for (const Triangle& triangle : box.triangles) {
        append(std::array<float, 3>{});
        for (const int v : triangle) {
            append(Vec3f(box.positions[v].cast<float>()));
        }
        append(attribute);
    }
    return bytes;
}

TEST_F(TextReaders, StlIsTheSameHoweverItIsWritten) {
    const std::string text = stlText();
    const std::vector<std::string> variants{
        text,
        upper(text),
        "\xef\xbb\xbf" + text,
        "\n\n" + text,
        "# a comment\n" + text,
        replaced(text, "\n", "\r\n"),
        replaced(text, "\n", "\r"),
        replaced(text, "normal 0 0 0", "normal -1.#IND nan 1.#INF"),
        replaced(text, "endfacet", "endfacet\n; a comment"),
        text + text.substr(0, 12) + "endsolid",
        stlBytes("binary"),
        stlBytes("solid not a text"),
        stlBytes("bytes") + "behind the end"};
    for (const std::string& variant : variants) {
        expectBox(stl(variant), variant.substr(0, 200));
    }
}

TEST_F(TextReaders, StlThatEndsTooEarlyIsRefused) {
    const std::string bytes = stlBytes("binary");
    EXPECT_THAT(sentence([&] { stl(bytes.substr(0, bytes.size() - 1)); }),
                HasSubstr("neither a binary STL as long as"));
    const std::string text = stlText();
    EXPECT_THAT(sentence([&] { stl(text.substr(0, text.rfind("endloop"))); }),
                HasSubstr("it ends without \"endsolid\""));
    EXPECT_THAT(sentence([&] { stl(text.substr(0, text.rfind("  facet"))); }),
                HasSubstr("it ends without \"endsolid\""));
    EXPECT_THAT(sentence([&] { stl(replaced(text, "-0.500000", "half")); }),
                HasSubstr("line 4: \"half\" stands where a number must"));
    EXPECT_THAT(sentence([&] { stl("solid\nendsolid\n"); }), HasSubstr("there is no surface"));
}

TEST_F(TextReaders, FacetsOfAnStlMayHaveAColour) {
    EXPECT_TRUE(stl(stlBytes("binary", 7)).soup.skin.colors.empty()) << "a number of a piece";
    const ImportedModel red = stl(stlBytes("VisCAM", 0x8000 | 31 << 10));
    ASSERT_EQ(red.soup.skin.colors.size(), 12U);
    EXPECT_TRUE(red.soup.skin.colors[3][0].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
}

const std::string kOffVertices = "0 0 0\n1 0 0\n0 2 0\n1 2 0\n0 0 3\n1 0 3\n0 2 3\n1 2 3\n";
const std::string kOffFaces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

TEST_F(TextReaders, OffIsTheSameHoweverItIsWritten) {
    const std::string off = "OFF\n8 6 0\n" + kOffVertices + kOffFaces;
    const std::vector<std::string> variants{
        off,
        "\xef\xbb\xbf" + off,
        "OFF 8 6 12\n" + kOffVertices + kOffFaces,
        "OFF\n8\n6\n12 # edges\n" + kOffVertices + kOffFaces,
        "OFF\n8 6\n" + kOffVertices + kOffFaces,
        "# a box\nOFF # of\n\n" + replaced(off.substr(4), "\n", " # comment\n\n"),
        replaced(off, "\n", "\r\n"),
        replaced(off, " ", "\t  "),
        "COFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 255 0 0 255\n") + kOffFaces,
        "NOFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 0 0 1\n") + kOffFaces,
        "4OFF\n8 6 0\n" + replaced(kOffVertices, "\n", " 1\n") + kOffFaces,
        "OFF\n8 6 0\n" + kOffVertices + replaced(kOffFaces, "\n", " 0.5 0.5 1\n")};
    for (const std::string& variant : variants) {
        expectBox(this->off(variant), variant);
    }
}

TEST_F(TextReaders, WhatAnOffCannotBeIsNamed) {
    const auto said = [&](const std::string& text) { return sentence([&] { off(text); }); };
    EXPECT_THAT(said("OFF BINARY\n"), HasSubstr("it is a binary OFF"));
    EXPECT_THAT(said("nOFF 4\n1 1 0\n"), HasSubstr("other than three dimensions"));
    EXPECT_THAT(said("8 6 0\n" + kOffVertices + kOffFaces), HasSubstr("does not begin with OFF"));
    EXPECT_THAT(said("OFF\n8 7 0\n" + kOffVertices + kOffFaces), HasSubstr("it ends too early"));
    EXPECT_THAT(said("OFF\n8 6 0\n" + replaced(kOffVertices, "3", "x") + kOffFaces),
                HasSubstr("line 7: \"x\" stands where a number must"));
    EXPECT_THAT(said("OFF\n8 1 0\n" + kOffVertices + "3 0 1 8\n"),
                HasSubstr("a face names vertex 8, counted from 0, and there are 8"));
}

TEST_F(TextReaders, ColoursOfAnOffAreOfItsVerticesOrFaces) {
    const auto colored =
        off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 1 255\n3 0 1 2\n");
    ASSERT_EQ(colored.soup.skin.colors.size(), 1U);
    EXPECT_TRUE(colored.soup.skin.colors[0][0].isApprox(Eigen::Vector4f(1, 0, 0, 1)));
    EXPECT_TRUE(colored.soup.skin.colors[0][1].isApprox(Eigen::Vector4f(0, 1, 0, 1)));
    const auto faces = off("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0 0 0 255\n");
    ASSERT_EQ(faces.soup.skin.colors.size(), 2U);
    EXPECT_TRUE(faces.soup.skin.colors[0][0].isApprox(Eigen::Vector4f(1, 1, 1, 1)));
    EXPECT_TRUE(faces.soup.skin.colors[1][0].isApprox(Eigen::Vector4f(0, 0, 1, 1)));
}

TEST(TextLines, ABackslashContinuesALineAndNoComment) {
    TextLines lines("f a \\\n b\n# c \\\nd\n\nf e\\");
    std::string all;
    while (lines.next()) {
        all += std::to_string(lines.number()) + ":" + std::string(lines.line()) + "|";
    }
    EXPECT_EQ(all, "1:f a  b|3:# c \\|4:d|5:|6:f e\\|");
}

}  // namespace
}  // namespace kerf::app
