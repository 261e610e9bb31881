#include "sim/mesh/box_surface.h"

namespace kerf {

namespace {

using Cells = std::array<int, 3>;

/// A corner of the grid: indices along the three axes.
struct Corner {
    Cells at{};
};

Vec3 position(const Corner& corner, const Vec3& size, const Cells& cells) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        p[axis] = size[axis] * (static_cast<double>(corner.at[axis]) / cells[axis] - 0.5);
    }
    return p;
}

/// One face, with corners of its own: welding joins the faces.
void addFace(TriangleSoup& soup, int axis, bool upper, const Vec3& size, const Cells& cells) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const int first = static_cast<int>(soup.positions.size());
    const int row = cells[v] + 1;
    for (int i = 0; i <= cells[u]; ++i) {
        for (int j = 0; j <= cells[v]; ++j) {
            Corner corner;
            corner.at[axis] = upper ? cells[axis] : 0;
            corner.at[u] = i;
            corner.at[v] = j;
            soup.positions.push_back(position(corner, size, cells));
        }
    }
    const auto add = [&](int a, int b, int c) {
        soup.triangles.push_back(upper ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    for (int i = 0; i < cells[u]; ++i) {
        for (int j = 0; j < cells[v]; ++j) {
            const int a = first + i * row + j;
            const int b = a + row;
            const int c = b + 1;
            const int d = a + 1;
            if ((i + j) % 2 == 0) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
}

}  // namespace

TriangleSoup boxSurface(const Vec3& size, const Cells& cells) {
    TriangleSoup soup;
    for (int axis = 0; axis < 3; ++axis) {
        addFace(soup, axis, false, size, cells);
        addFace(soup, axis, true, size, cells);
    }
    return weldExactly(soup);
}

}  // namespace kerf
