// A tetrahedron in each format that is a text, with white space of each sort in each place: it is
// read as it is, or a sentence says why not.
#include "app/files/import/import_answer.h"

namespace kerf::app {
namespace {

struct TextFormat {
    const char* extension;
    std::string text;
};

/// A triangle of a text STL.
std::string facet(const std::array<const char*, 3>& corners) {
    std::string text = "facet normal 0 0 0\nouter loop\n";
    for (const char* corner : corners) {
        text += "vertex " + std::string(corner) + "\n";
    }
    return text + "endloop\nendfacet\n";
}

std::vector<TextFormat> textFormats() {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    const std::string corners = "0 2 1 0 1 3\n0 3 2 1 2 3\n";
    const char* o = "0 0 0";
    const char* x = "1 0 0";
    const char* y = "0 1 0";
    const char* z = "0 0 1";
    return {
        {".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"},
        {".off", "OFF\n4 4 0\n" + points + faces},
        {".off", "4 4 0\n" + points + faces},
        {".ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\nproperty list uchar int vertex_index\nend_header\n" +
             points + faces},
        {".stl", "solid a\n" + facet({o, y, x}) + facet({o, x, z}) + facet({o, z, y}) +
                     facet({x, y, z}) + "endsolid a\n"},
        {".dae",
         "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">\n<library_geometries>\n"
         "<geometry id=\"g\"> <mesh>\n<source id=\"s\"> <float_array id=\"a\" count=\"12\">\n" +
             points +
             "</float_array> <technique_common> <accessor source=\"#a\" count=\"4\" stride=\"3\">\n"
             "<param name=\"X\" type=\"float\"/> <param name=\"Y\" type=\"float\"/>\n"
             "<param name=\"Z\" type=\"float\"/> </accessor> </technique_common> </source>\n"
             "<vertices id=\"v\"> <input semantic=\"POSITION\" source=\"#s\"/> </vertices>\n"
             "<polylist count=\"4\"> <input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>\n"
             "<vcount> 3 3 3 3 </vcount> <p>\n" +
             corners +
             "</p> </polylist> </mesh> </geometry> </library_geometries>\n"
             "<library_visual_scenes> <visual_scene id=\"w\"> <node id=\"n\">\n"
             "<matrix> 1 0 0 0 0 1 0 0\n0 0 1 0 0 0 0 1 </matrix>\n"
             "<instance_geometry url=\"#g\"/> </node> </visual_scene> </library_visual_scenes>\n"
             "<scene> <instance_visual_scene url=\"#w\"/> </scene>\n</COLLADA>\n"},
        {".gltf",
         "{ \"asset\": { \"version\": \"2.0\" },\n\"scene\": 0, \"scenes\": [ { \"nodes\": [ 0 ] } "
         "],\n\"nodes\": [ { \"mesh\": 0 } ],\n\"meshes\": [ { \"primitives\": [ { \"attributes\": "
         "{ \"POSITION\": 0 }, \"indices\": 1 } ] } ],\n\"buffers\": [ { \"byteLength\": 60, "
         "\"uri\": \"data:application/octet-stream;base64," +
             [] {
                 const std::array<float, 12> at{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
                 const std::array<std::uint8_t, 12> of{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
                 return base64(std::string(reinterpret_cast<const char*>(at.data()), sizeof at) +
                               std::string(reinterpret_cast<const char*>(of.data()), sizeof of));
             }() +
             "\" } ],\n\"bufferViews\": [ { \"buffer\": 0, \"byteLength\": 48 }, { \"buffer\": 0, "
             "\"byteOffset\": 48, \"byteLength\": 12 } ],\n\"accessors\": [ { \"bufferView\": 0, "
             "\"componentType\": 5126, \"type\": \"VEC3\", \"count\": 4, \"min\": [ 0, 0, 0 ], "
             "\"max\": [ 1, 1, 1 ] },\n{ \"bufferView\": 1, \"componentType\": 5121, \"type\": "
             "\"SCALAR\", \"count\": 12 } ] }\n"},
        {".vtk", "# vtk DataFile Version 3.0\na title\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" +
                     points + "POLYGONS 4 16\n" + faces},
        {".vtp",
         "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData> <Piece "
         "NumberOfPoints=\"4\">\n<Points> <DataArray type=\"Float32\" format=\"ascii\">\n" +
             points +
             "</DataArray> </Points>\n<Polys> <DataArray type=\"Int32\" Name=\"connectivity\" "
             "format=\"ascii\">\n" +
             corners +
             "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\"> 3 6\n9 12 "
             "</DataArray> </Polys>\n</Piece> </PolyData>\n</VTKFile>\n"},
        {".msh",
         "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
         "$EndNodes\n$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n"}};
}

class WhiteSpace : public ::testing::Test {
  protected:
    /// Why the text is refused; empty if it is read as the tetrahedron. Fails the test where
    /// another shape comes of it.
    std::string refusalOf(const TextFormat& format, const std::string& text) {
        const fs::path file = folder_ / ("a" + std::string(format.extension));
        writeText(file, text);
        const ImportAnswer answer = answersTo(file, {ImportOrder{}}).front();
        const bool same = answer.report.cuttable && std::abs(answer.report.volume - 1.0 / 6) < 1e-6;
        EXPECT_TRUE(same || !answer.reason.empty()) << format.extension << ":\n" << text;
        return answer.reason;
    }

  private:
    test::TemporaryFolder folder_;
};

struct Spread {
    const char* from;
    const char* to;
};

TEST_F(WhiteSpace, ThatIsUsualIsReadEverywhere) {
    for (const TextFormat& format : textFormats()) {
        EXPECT_EQ(refusalOf(format, format.text), "") << format.extension;
        EXPECT_EQ(refusalOf(format, "\xef\xbb\xbf" + format.text), "") << format.extension;
        EXPECT_EQ(refusalOf(format, format.text.substr(0, format.text.size() - 1)), "");
        for (const auto& [from, to] : {Spread{" ", "\t"},
                                       {" ", "  "},
                                       {" ", " \t "},
                                       {"\n", "\r\n"},
                                       {"\n", "\r"},
                                       {"\n", " \n"},
                                       {"\n", "\t\r\n"},
                                       {"\n", "\n "},
                                       {"\n", "\n\t"}}) {
            const std::string text = replaced(format.text, from, to);
            EXPECT_EQ(refusalOf(format, text), "") << format.extension << ":\n" << text;
        }
    }
}

TEST_F(WhiteSpace, OfAnySortInAnyPlaceIsReadOrRefusedInWords) {
    int read = 0;
    int refused = 0;
    for (const TextFormat& format : textFormats()) {
        const std::string& text = format.text;
        for (std::size_t at = 0; at <= text.size(); ++at) {
            if (at > 0 && at < text.size() && text[at] != ' ' && text[at] != '\n') {
                continue;
            }
            for (const char* sort : {" ", "\t", "\n", "\r\n", "\r", "\v", "\f", "\n\n"}) {
                std::string put = text;
                put.insert(at, sort);
                std::string instead = text;
                instead.replace(at, at < text.size() ? 1 : 0, sort);
                for (const std::string& spread : {put, instead}) {
                    ++(refusalOf(format, spread).empty() ? read : refused);
                }
            }
        }
    }
    EXPECT_GT(read, 4 * refused);
}

}  // namespace
}  // namespace kerf::app
