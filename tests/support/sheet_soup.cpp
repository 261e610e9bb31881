#include "tests/support/sheet_soup.h"

namespace kerf::test {

TriangleSoup sheetSoup(int n, const Height& height) {
    TriangleSoup soup;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = static_cast<double>(i) / n;
            const double z = static_cast<double>(j) / n;
            soup.positions.emplace_back(x, height(x, z), z);
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            const int c = a + n + 1;
            soup.triangles.push_back({a, c, c + 1});
            soup.triangles.push_back({a, c + 1, a + 1});
        }
    }
    return soup;
}

}  // namespace kerf::test
