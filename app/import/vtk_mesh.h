#pragma once

#include "app/import/file_numbers.h"
#include "app/import/mesh_cells.h"

namespace kerf::app {

/// The corners of many cells, one after the other.
struct VtkCells {
    std::vector<double> corners;
    std::vector<double> ends;   ///< by cell: where its corners end
    std::vector<double> types;  ///< by cell: VTK's number of its kind
};
inline constexpr double kVtkStrip = 6;
inline constexpr double kVtkPolygon = 7;

/// Throws InputError for a data set that is neither poly data nor an unstructured grid.
void requireVtkSurface(const std::string& kind);

/// Whether an array of points holds their colours: by its name, or bytes.
bool isVtkColor(std::string_view name, double components, bool ofBytes);

/// What a VTK file holds, in whichever format.
class VtkMesh {
  public:
    VtkMesh() = default;
    VtkMesh(const VtkMesh&) = delete;
    VtkMesh& operator=(const VtkMesh&) = delete;

    /// Cells that follow count from the first of these.
    void addPoints(const std::vector<double>& coordinates);
    /// `pieces`: by cell the number of its piece of a cut body, as Kerf writes it; without one for
    /// each they are ignored. Throws InputError for a kind that is not read.
    void addCells(const VtkCells& cells, const std::vector<double>& pieces = {});
    /// Of the points that were added last, three or four shares of `most` each.
    void addColors(std::size_t components, double most, const std::vector<double>& numbers);
    /// All of it, which leaves nothing here.
    ImportedModel takeModel();

  private:
    FaceSoup faces_;
    MeshCells cells_{faces_};
    std::size_t first_ = 0;  ///< of the points that were added last
};

/// Reads a legacy VTK file of poly data or of an unstructured grid, as text or binary; the skin of
/// cells with a volume, curved ones by their corners; colours of points. Throws InputError for
/// another data set, and a truncated file.
ImportedModel readVtk(const std::filesystem::path& file);

/// The same of a VTK XML file (.vtp, .vtu): arrays as text, base64 or appended, with zlib or
/// without; the pieces of a cut body, as Kerf writes them.
ImportedModel readVtkXml(const std::filesystem::path& file);

/// Reads a Gmsh file of version 2.2 or 4.1, as text or binary: its surface, or the skin of its
/// volumes. Throws InputError for another version, and a truncated file.
ImportedModel readGmsh(const std::filesystem::path& file);

}  // namespace kerf::app
