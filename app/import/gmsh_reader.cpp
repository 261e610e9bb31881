#include <unordered_map>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/vtk_mesh.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

struct GmshType {
    CellShape shape;
    double nodes;  ///< corners first
};

const GmshType& gmshTypeOf(double number) {
    using enum CellShape;
    static const std::map<double, GmshType> types{
        {1, {leftOut, 2}},     {2, {triangle, 3}},      {3, {quad, 4}},
        {4, {tetrahedron, 4}}, {5, {hexahedron, 8}},    {6, {wedge, 6}},
        {7, {pyramid, 5}},     {8, {leftOut, 3}},       {9, {triangle, 6}},
        {10, {quad, 9}},       {11, {tetrahedron, 10}}, {12, {hexahedron, 27}},
        {13, {wedge, 18}},     {14, {pyramid, 14}},     {15, {leftOut, 1}},
        {16, {quad, 8}},       {17, {hexahedron, 20}},  {18, {wedge, 15}},
        {19, {pyramid, 13}}};
    const auto found = types.find(number);
    if (found == types.end()) {
        throw InputError("it has elements of Gmsh's type " + formatNumber(number) +
                         ", which are not read; save it with elements of order 1 or 2");
    }
    return found->second;
}

/// The sections of a file, in whatever order but for nodes before elements.
class GmshMesh {
  public:
    explicit GmshMesh(std::string_view bytes) : file_(withoutMark(bytes), Encoding::text) {}

    ImportedModel read() {
        namingPlace(file_, [&] {
            readFormat();
            for (std::string_view name = file_.word(); !name.empty(); name = file_.word()) {
                readSection(name);
            }
        });
        ImportedModel model;
        cells_.finish(model.remarks);
        takeFaces(faces_, model);
        return model;
    }

  private:
    /// A count in version 2 stands on a line of its own as text, whatever follows.
    double countOnLine() {
        const double count = numberOf(file_.word());
        file_.line();
        return count;
    }
    double integer() { return file_.next(*int_); }
    double size() { return file_.next(*size_); }

    void readFormat() {
        if (file_.word() != "$MeshFormat") {
            throw InputError("it does not begin with \"$MeshFormat\", so it is no file of Gmsh");
        }
        const std::string version(file_.word());
        isNew_ = version == "4.1";
        if (!isNew_ && version != "2.2" && version != "2") {
            throw InputError("it is of version " + printable(version.substr(0, 40)) +
                             " of Gmsh's format; save it in version 4.1 or 2.2");
        }
        isText_ = numberOf(file_.word()) != 1;
        size_ = numberOf(file_.word()) == 4 ? findScalar("uint") : findScalar("ulong");
        file_.line();
        if (!isText_) {
            file_.setEncoding(Encoding::littleEndian);
            const bool isLittle = integer() == 1;  // as it is written
            file_.setEncoding(isLittle ? Encoding::littleEndian : Encoding::bigEndian);
        }
        requireEnd("$MeshFormat");
    }

    void readSection(std::string_view name) {
        if (!name.starts_with('$')) {
            throw InputError("\"" + printable(std::string(name.substr(0, 40))) +
                             "\" stands where a section must begin");
        }
        file_.line();
        if (name == "$Nodes") {
            isNew_ ? readNodeBlocks() : readNodes();
        } else if (name == "$Elements") {
            isNew_ ? readElementBlocks() : readElements();
        } else {
            file_.skip(file_.rest().find("$End" + std::string(name.substr(1))));
        }
        requireEnd(name);
    }
    void requireEnd(std::string_view name) {
        const std::string end = "$End" + std::string(name.substr(1));
        if (file_.word() != end) {
            throw InputError("its section \"" + printable(std::string(name.substr(0, 40))) +
                             "\" does not end");
        }
    }

    void addNode(double tag, const std::vector<double>& place) {
        numbers_[tag] = static_cast<double>(faces_.positions.size());
        faces_.positions.emplace_back(place[0], place[1], place[2]);
    }
    void addElement(const GmshType& type, std::vector<double> nodes) {
        for (double& node : nodes) {
            const auto found = numbers_.find(node);
            if (found == numbers_.end()) {
                throw InputError("an element names node " + formatNumber(node) +
                                 ", which is not there");
            }
            node = found->second;
        }
        cells_.add(type.shape, nodes);
    }

    void readNodes() {
        const double count = countOnLine();
        for (double i = 0; i < count; ++i) {
            const double tag = integer();
            addNode(tag, file_.list(*double_, 3));
        }
    }
    /// A text has no heads of blocks: each element is one.
    void readElements() {
        const double count = countOnLine();
        double inBlock = 1;
        for (double i = 0; i < count; i += inBlock) {
            if (isText_) {
                integer();
            }
            const GmshType& type = gmshTypeOf(integer());
            inBlock = isText_ ? 1 : integer();
            const double tags = integer() + (isText_ ? 0 : 1);
            for (double k = 0; k < inBlock; ++k) {
                file_.list(*int_, tags);
                addElement(type, file_.list(*int_, type.nodes));
            }
        }
    }

    void readNodeBlocks() {
        const double blocks = size();
        file_.list(*size_, 3);  // how many in all, the least tag and the largest
        for (double i = 0; i < blocks; ++i) {
            const double dimension = integer();
            integer();
            const bool hasParameters = integer() != 0;
            const std::vector<double> tags = file_.list(*size_, size());
            for (const double tag : tags) {
                addNode(tag, file_.list(*double_, 3));
                file_.list(*double_, hasParameters ? dimension : 0);
            }
        }
    }
    void readElementBlocks() {
        const double blocks = size();
        file_.list(*size_, 3);
        for (double i = 0; i < blocks; ++i) {
            file_.list(*int_, 2);
            const GmshType& type = gmshTypeOf(integer());
            const double count = size();
            for (double k = 0; k < count; ++k) {
                size();
                addElement(type, file_.list(*size_, type.nodes));
            }
        }
    }

    FileNumbers file_;
    bool isNew_ = false;
    bool isText_ = true;
    const Scalar* int_ = findScalar("int");
    const Scalar* double_ = findScalar("double");
    const Scalar* size_ = nullptr;  ///< of counts and tags in version 4
    FaceSoup faces_;
    MeshCells cells_{faces_};
    std::unordered_map<double, double> numbers_;  ///< of nodes, by their tags
};

}  // namespace

ImportedModel readGmsh(const std::filesystem::path& file) {
    return GmshMesh(readInputFile(file, kMaxModelBytes)).read();
}

}  // namespace kerf::app
