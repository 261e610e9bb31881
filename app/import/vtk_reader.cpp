#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/vtk_mesh.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

[[noreturn]] void refuseWord(const std::string& word, const char* wanted) {
    constexpr std::size_t kShown = 40;  // letters
    throw InputError("\"" + printable(word.substr(0, kShown)) + "\" stands where " + wanted +
                     " must");
}

/// By its name in a legacy file.
const Scalar& vtkTypeOf(const std::string& named) {
    std::string name = lowerCase(named);
    for (const auto& [other, own] :
         {std::pair{"unsigned_", "u"}, {"vtkidtype", "int"}, {"vtktype", ""}}) {
        name = name.starts_with(other) ? own + name.substr(std::string(other).size()) : name;
    }
    const Scalar* const type = findScalar(name);
    if (type == nullptr) {
        refuseWord(named, "a type of numbers");
    }
    return *type;
}

/// The sections of a legacy file, in whatever order.
class LegacyVtk {
  public:
    explicit LegacyVtk(std::string_view bytes) : file_(withoutMark(bytes), Encoding::text) {}

    ImportedModel read() {
        std::string remark;
        namingPlace(file_, [&] {
            readHead();
            std::string key = nextKey();
            while (!key.empty() && readSection(key)) {
                key = nextKey();
            }
            remark = key.empty() ? ""
                                 : "What stands from " + file_.place() +
                                       " on was left out: Kerf does not know it.";
        });
        ImportedModel model = mesh_.takeModel();
        if (!remark.empty()) {
            model.remarks.push_back(std::move(remark));
        }
        return model;
    }

  private:
    std::string word() { return std::string(file_.word()); }
    double number() { return numberOf(file_.word()); }
    std::string nextKey() {
        std::string key = lowerCase(word());
        while (key == "metadata") {
            file_.line();
            while (!file_.line().empty()) {
            }
            key = lowerCase(word());
        }
        return key;
    }

    void readHead() {
        FileNumbers ahead = file_;
        std::string_view first = ahead.line();
        std::string head;  // without blanks: some leave them out
        for (std::string_view word = takeWord(first); !word.empty(); word = takeWord(first)) {
            head += word;
        }
        if (!head.starts_with("#vtkDataFileVersion")) {
            throw InputError("it does not begin with \"# vtk DataFile Version\"");
        }
        file_.line();
        file_.line();  // a title
        const std::string encoding = lowerCase(word());
        if (encoding != "ascii" && encoding != "binary") {
            refuseWord(encoding, "ASCII or BINARY");
        }
        isText_ = encoding == "ascii";
        file_.setEncoding(isText_ ? Encoding::text : Encoding::bigEndian);
    }

    /// False for one that is not known, behind the cells.
    bool readSection(const std::string& key) {
        static const std::map<std::string, double> lists{{"vertices", 1},
                                                         {"lines", 4},
                                                         {"triangle_strips", kVtkStrip},
                                                         {"polygons", kVtkPolygon},
                                                         {"cells", 0}};
        static const std::set<std::string> data{
            "field",   "scalars", "color_scalars", "texture_coordinates", "vectors",
            "normals", "tensors", "global_ids",    "pedigree_ids"};
        if (key == "dataset") {
            requireVtkSurface(word());
        } else if (key == "points") {
            const double count = number();
            mesh_.addPoints(listOf(word(), 3 * count));
        } else if (const auto list = lists.find(key); list != lists.end()) {
            cells_ = readCells();
            cells_.types.assign(cells_.ends.size(), list->second);
            mesh_.addCells(cells_);  // Of several kinds nothing yet.
        } else if (key == "cell_types") {
            cells_.types = listOf("int", number());
            mesh_.addCells(cells_);
        } else if (key == "cell_data" || key == "point_data") {
            ofPoints_ = key == "point_data";
            count_ = number();
        } else if (data.contains(key)) {
            readData(key);
        } else if (cells_.ends.empty()) {
            refuseWord(key, "the word of a section");
        } else {
            return false;
        }
        return true;
    }

    void readData(const std::string& key) {
        const std::string name = word();
        if (key == "field") {
            for (double left = number(); left > 0; --left) {
                const std::string array = nextKey();
                const double components = number();
                const double count = number();
                readArray(array, components, count, word());
            }
        } else if (key == "scalars") {
            const std::string type = word();
            const std::string_view components = file_.line();
            word();  // LOOKUP_TABLE
            readArray(name, components.empty() ? 1 : numberOf(components), count_, type);
        } else if (key == "color_scalars") {
            readArray("color", number(), count_, isText_ ? "float" : "uchar");
        } else if (key == "texture_coordinates") {
            const double components = number();
            readArray(name, components, count_, word());
        } else {
            const bool isVector = key == "vectors" || key == "normals";
            readArray(name, key == "tensors" ? 9 : isVector ? 3 : 1, count_, word());
        }
    }
    void readArray(const std::string& name, double components, double count,
                   const std::string& typeName) {
        const std::vector<double> numbers = listOf(typeName, components * count);
        const Scalar& type = vtkTypeOf(typeName);
        if (ofPoints_ && isVtkColor(name, components, type.name == "uchar")) {
            mesh_.addColors(static_cast<std::size_t>(components), type.most, numbers);
        }
    }
    /// Those behind the line.
    std::vector<double> listOf(const std::string& typeName, double count) {
        const Scalar& type = vtkTypeOf(typeName);
        file_.line();
        return file_.list(type, count);
    }

    /// Since version 5 in two lists, before that each with its number of corners before them.
    VtkCells readCells() {
        const double count = number();
        const double size = number();
        file_.line();
        FileNumbers ahead = file_;
        VtkCells cells;
        if (lowerCase(std::string(ahead.word())) == "offsets") {
            nextKey();
            cells.ends = listOf(word(), count);
            cells.ends.erase(cells.ends.begin(), cells.ends.begin() + (count > 0 ? 1 : 0));
            nextKey();  // CONNECTIVITY
            cells.corners = listOf(word(), size);
            return cells;
        }
        const Scalar& integer = *findScalar("int");
        for (double i = 0; i < count; ++i) {
            const std::vector<double> corners = file_.list(integer, file_.next(integer));
            cells.corners.insert(cells.corners.end(), corners.begin(), corners.end());
            cells.ends.push_back(static_cast<double>(cells.corners.size()));
        }
        return cells;
    }

    FileNumbers file_;
    bool isText_ = true;
    VtkMesh mesh_;
    VtkCells cells_;
    bool ofPoints_ = false;  ///< what is read is of points, else of cells
    double count_ = 0;       ///< of these
};

}  // namespace

ImportedModel readVtk(const std::filesystem::path& file) {
    return LegacyVtk(readInputFile(file, kMaxModelBytes)).read();
}

}  // namespace kerf::app
