// From top to bottom: how arrays are packed; arrays; what becomes of them.

#include <zlib.h>

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/import/vtk_mesh.h"
#include "app/import/xml_file.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// Head and data may be encoded apart, each padded at its end.
std::string bytesOfParts(std::string_view text) {
    std::string bytes;
    while (!text.empty()) {
        const std::size_t padding = std::min(text.find('='), text.size());
        const std::size_t end = std::min(text.find_first_not_of('=', padding), text.size());
        bytes += bytesOfBase64(text.substr(0, end));
        text.remove_prefix(end);
    }
    return bytes;
}

/// What stands behind the names of arrays, as the root of the file says.
struct VtkPacking {
    explicit VtkPacking(const pugi::xml_node& root)
        : encoding(root.attribute("byte_order").value() == std::string_view("BigEndian")
                       ? Encoding::bigEndian
                       : Encoding::littleEndian),
          head(*findScalar(root.attribute("header_type").value() == std::string_view("UInt64")
                               ? "uint64"
                               : "uint32")) {
        const std::string_view compressor = root.attribute("compressor").value();
        isPacked = !compressor.empty();
        if (isPacked && compressor != "vtkZLibDataCompressor") {
            throw InputError("it is compressed by " + printable(std::string(compressor)) +
                             ", which is not read; export it with ZLib or without compression");
        }
    }

    /// Lengths, then blocks; or one length.
    std::string unpacked(std::string_view bytes) const {
        FileNumbers file(bytes, encoding);
        const double count = file.next(head);
        if (!isPacked) {
            if (count > static_cast<double>(file.rest().size())) {
                throw InputError("it ends");
            }
            return std::string(file.rest().substr(0, static_cast<std::size_t>(count)));
        }
        const double size = file.next(head);
        const double last = file.next(head);
        const std::vector<double> lengths = file.list(head, count);
        std::string all;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            const bool isCut = i + 1 == lengths.size() && last > 0;
            addBlock(file.rest(), lengths[i], isCut ? last : size, all);
            file.skip(static_cast<std::size_t>(lengths[i]));
        }
        return all;
    }

    Encoding encoding;
    const Scalar& head;  ///< the type of lengths
    bool isPacked = false;

  private:
    static void addBlock(std::string_view bytes, double length, double size, std::string& all) {
        constexpr double kMostRatio = 1100;  // of zlib
        if (length > static_cast<double>(bytes.size()) || size > kMostRatio * length ||
            static_cast<double>(all.size()) + size > static_cast<double>(kMaxModelBytes)) {
            throw InputError("its blocks are shorter or longer than their head says");
        }
        const std::size_t begin = all.size();
        auto written = static_cast<uLongf>(size);
        all.resize(begin + written);
        const int status =
            ::uncompress(reinterpret_cast<Bytef*>(all.data() + begin), &written,
                         reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(length));
        if (status != Z_OK || begin + written != all.size()) {
            throw InputError("its compressed data is damaged");
        }
    }
};

/// The arrays of a file.
class VtkArrays {
  public:
    explicit VtkArrays(std::string_view bytes) {
        constexpr std::string_view kTag = "<AppendedData";
        const std::size_t tag = bytes.find(kTag);
        const std::size_t begin = std::min(bytes.find('_', bytes.find('>', tag)), bytes.size());
        const bool hasAppended = tag != std::string_view::npos;
        // What is appended may be no XML.
        const std::string text =
            hasAppended ? std::string(bytes.substr(0, begin)) + "</AppendedData></VTKFile>"
                        : std::string(bytes);
        loadXml(text, document_);
        root_ = document_.child("VTKFile");
        packing_.emplace(root_);
        if (hasAppended) {
            appended_ = bytes.substr(std::min(begin + 1, bytes.size()));
            appended_ = appended_.substr(0, appended_.rfind("</AppendedData"));
            isRaw_ = root_.child("AppendedData").attribute("encoding").value() ==
                     std::string_view("raw");
            for (const auto& found : root_.select_nodes("//DataArray[@offset]")) {
                offsets_.insert(found.node().attribute("offset").as_ullong());
            }
        }
    }

    const pugi::xml_node& root() const { return root_; }

    std::vector<double> numbersOf(const pugi::xml_node& array) const {
        try {
            const std::string_view format = array.attribute("format").value();
            if (format == "ascii") {
                return FileNumbers(array.text().get(), Encoding::text).all(typeOf(array));
            }
            const std::string bytes = packing_->unpacked(
                format == "appended" ? appendedBytes(array) : bytesOfParts(array.text().get()));
            return FileNumbers(bytes, packing_->encoding).all(typeOf(array));
        } catch (const InputError& error) {
            throw InputError("its array \"" + printable(array.attribute("Name").value()) +
                             "\": " + error.what());
        }
    }
    /// Of a node's arrays that of the name; empty for none.
    std::vector<double> numbersOf(const pugi::xml_node& node, const char* name) const {
        const pugi::xml_node found = node.find_child_by_attribute("DataArray", "Name", name);
        return found ? numbersOf(found) : std::vector<double>();
    }

    static const Scalar& typeOf(const pugi::xml_node& array) {
        const std::string name = array.attribute("type").value();
        const Scalar* const type = findScalar(lowerCase(name));
        if (type == nullptr) {
            throw InputError("\"" + printable(name.substr(0, 40)) + "\" is no type of numbers");
        }
        return *type;
    }

  private:
    /// Up to where the next one begins.
    std::string appendedBytes(const pugi::xml_node& array) const {
        const std::uint64_t begin = array.attribute("offset").as_ullong();
        const auto next = offsets_.upper_bound(begin);
        if (begin >= appended_.size()) {
            throw InputError("it is not there");
        }
        const std::string_view own = appended_.substr(
            begin, next == offsets_.end() ? std::string_view::npos : *next - begin);
        return isRaw_ ? std::string(own) : bytesOfParts(own);
    }

    pugi::xml_document document_;
    pugi::xml_node root_;
    std::optional<VtkPacking> packing_;
    std::string_view appended_;
    std::set<std::uint64_t> offsets_;
    bool isRaw_ = false;
};

void readPiece(const pugi::xml_node& piece, const VtkArrays& arrays, VtkMesh& mesh) {
    const double count = piece.attribute("NumberOfPoints").as_double();
    const pugi::xml_node points = piece.child("Points").child("DataArray");
    const std::vector<double> places = points ? arrays.numbersOf(points) : std::vector<double>();
    if (static_cast<double>(places.size()) != 3 * count) {
        throw InputError("its points have " + std::to_string(places.size()) + " coordinates, and " +
                         formatNumber(count) + " of them need three each");
    }
    mesh.addPoints(places);
    for (const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
        const auto components = array.attribute("NumberOfComponents").as_uint(1);
        const bool ofBytes = array.attribute("type").value() == std::string_view("UInt8");
        if (isVtkColor(array.attribute("Name").value(), components, ofBytes)) {
            mesh.addColors(components, VtkArrays::typeOf(array).most, arrays.numbersOf(array));
        }
    }
    const std::vector<double> pieces = arrays.numbersOf(piece.child("CellData"), "piece");
    for (const auto& [name, type] :
         {std::pair{"Polys", kVtkPolygon}, {"Strips", kVtkStrip}, {"Cells", 0.0}}) {
        const pugi::xml_node node = piece.child(name);
        VtkCells cells{arrays.numbersOf(node, "connectivity"), arrays.numbersOf(node, "offsets"),
                       arrays.numbersOf(node, "types")};
        if (type != 0) {
            cells.types.assign(cells.ends.size(), type);
        }
        mesh.addCells(cells, pieces);
    }
}

}  // namespace

ImportedModel readVtkXml(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    const VtkArrays arrays(bytes);
    const std::string kind = arrays.root().attribute("type").value();
    requireVtkSurface(kind);
    VtkMesh mesh;
    for (const pugi::xml_node piece : arrays.root().child(kind.c_str()).children("Piece")) {
        readPiece(piece, arrays, mesh);
    }
    return mesh.takeModel();
}

}  // namespace kerf::app
