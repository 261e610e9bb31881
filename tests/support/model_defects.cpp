#include "tests/support/model_defects.h"

#include "sim/base/math.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

void drop(TriangleSoup& soup, std::size_t t) {
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(t));
}

using Defects = std::map<std::string, std::function<void(TriangleSoup&)>>;

Defects makeDefects() {
    return {
        {"hole of one triangle", [](TriangleSoup& s) { drop(s, 5); }},
        {"large hole",
         [](TriangleSoup& s) {
             std::erase_if(s.triangles,
                           [&](const Triangle& t) { return s.positions[t[0]].y() > 0.3; });
         }},
        {"two holes that touch in a vertex",
         [](TriangleSoup& s) {
             const int v = s.triangles[40][0];
             std::vector<int> around;
             for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
                 if (std::ranges::find(s.triangles[t], v) != s.triangles[t].end()) {
                     around.push_back(t);
                 }
             }
             for (const int other : around) {
                 const auto& a = s.triangles[around[0]];
                 const int common = static_cast<int>(std::ranges::count_if(a, [&](int x) {
                     return std::ranges::find(s.triangles[other], x) != s.triangles[other].end();
                 }));
                 if (common == 1) {
                     drop(s, std::max(other, around[0]));
                     drop(s, std::min(other, around[0]));
                     return;
                 }
             }
         }},
        {"turned triangles",
         [](TriangleSoup& s) {
             for (std::size_t t = 0; t < s.triangles.size(); t += 7) {
                 std::swap(s.triangles[t][1], s.triangles[t][2]);
             }
         }},
        {"inside out", [](TriangleSoup& s) { s = turned(s); }},
        {"doubles",
         [](TriangleSoup& s) {
             s.triangles.push_back(s.triangles[3]);
             s.triangles.push_back({s.triangles[9][1], s.triangles[9][2], s.triangles[9][0]});
         }},
        {"a flap of two sides",
         [](TriangleSoup& s) {
             const int tip = static_cast<int>(s.positions.size());
             s.positions.emplace_back(0, 0.9, 0);
             const Triangle& t = s.triangles[0];
             const int a = t[0];
             const int b = t[1];
             s.triangles.push_back({a, b, tip});
             s.triangles.push_back({b, a, tip});
         }},
        {"everything twice, once for each side",
         [](TriangleSoup& s) {
             const TriangleSoup other = turned(s);
             s.triangles.insert(s.triangles.end(), other.triangles.begin(), other.triangles.end());
         }},
        {"a triangle without area",
         [](TriangleSoup& s) {
             // The middle of an edge that only one of its triangles knows, exactly.
             const Triangle t = s.triangles[11];
             for (const int v : {t[0], t[1]}) {
                 s.positions[v] = (s.positions[v] * 1024).array().round() / 1024;
             }
             const int middle = static_cast<int>(s.positions.size());
             s.positions.push_back(0.5 * (s.positions[t[0]] + s.positions[t[1]]));
             s.triangles[11] = {t[0], middle, t[2]};
             s.triangles.push_back({middle, t[1], t[2]});
             s.triangles.push_back({t[0], t[1], middle});
         }},
        {"a T-junction",
         [](TriangleSoup& s) {
             const Triangle t = s.triangles[11];
             const int middle = static_cast<int>(s.positions.size());
             s.positions.push_back(0.5 * (s.positions[t[0]] + s.positions[t[1]]));
             s.triangles[11] = {t[0], middle, t[2]};
             s.triangles.push_back({middle, t[1], t[2]});
         }},
        {"repeated corners",
         [](TriangleSoup& s) {
             s.triangles.push_back({4, 4, 9});
         }},
        {"an index that is not there",
         [](TriangleSoup& s) {
             s.triangles.push_back({4, 5, 99999});
         }},
        {"vertices that nearly meet",
         [](TriangleSoup& s) {
             const auto copy = static_cast<int>(s.positions.size());
             const Triangle t = s.triangles[20];
             s.positions.push_back(s.positions[t[0]] + Vec3(3e-7, -2e-7, 1e-7));
             s.triangles[20] = {copy, t[1], t[2]};
         }},
        {"loose triangles",
         [](TriangleSoup& s) {
             const auto first = static_cast<int>(s.positions.size());
             s.positions.emplace_back(2, 0, 0);
             s.positions.emplace_back(2, 0.1, 0);
             s.positions.emplace_back(2, 0, 0.1);
             s.triangles.push_back({first, first + 1, first + 2});
         }},
        {"an inner wall",
         [](TriangleSoup& s) {
             // A fan over a ring of the surface: three triangles at each of its edges.
             const int v = s.triangles[40][0];
             const auto hub = static_cast<int>(s.positions.size());
             const std::size_t count = s.triangles.size();
             s.positions.push_back(0.6 * s.positions[v]);
             for (std::size_t t = 0; t < count; ++t) {
                 for (int i = 0; i < 3; ++i) {
                     if (s.triangles[t][i] == v) {
                         s.triangles.push_back(
                             {s.triangles[t][(i + 1) % 3], s.triangles[t][(i + 2) % 3], hub});
                     }
                 }
             }
         }},
        {"sheets that touch it in vertices",
         [](TriangleSoup& s) {
             // Tilted, so that rounding gives what fills them a volume.
             for (const int v : {0, 5, 9}) {
                 const Vec3 at = s.positions[v];
                 const auto first = static_cast<int>(s.positions.size());
                 for (const Vec3& way : {Vec3(0.31, 0.17, 0), Vec3(0.05, 0.27, 0.23)}) {
                     s.positions.emplace_back(at + way);
                     s.positions.emplace_back(at - way);
                 }
                 s.triangles.push_back({v, first, first + 2});
                 s.triangles.push_back({v, first + 2, first + 1});
                 s.triangles.push_back({v, first + 1, first + 3});
                 s.triangles.push_back({v, first + 3, first});
             }
             std::ranges::transform(s.positions, s.positions.begin(), nearestFloats);
         }},
        {"boxes that share an edge",
         [](TriangleSoup& s) {
             s = joined(s, boxSoup(Vec3::Constant(0.2)), Vec3(2, 0, 0));
             s = joined(s, boxSoup(Vec3::Constant(0.2)), Vec3(2.2, 0.2, 0));
         }},
        {"boxes that share a vertex",
         [](TriangleSoup& s) {
             s = joined(s, boxSoup(Vec3::Constant(0.25)), Vec3(2, 0, 0));
             s = joined(s, boxSoup(Vec3::Constant(0.25)), Vec3(2.25, 0.25, 0.25));
         }},
        {"a cavity that faces outward",
         [](TriangleSoup& s) { s = joined(s, icosphereSoup(2, 0.2), Vec3::Zero()); }},
    };
}

}  // namespace

const Defects& modelDefects() {
    static const Defects kDefects = makeDefects();
    return kDefects;
}

TriangleSoup soundBall() {
    return icosphereSoup(3);
}

void damage(TriangleSoup& soup, std::mt19937& random, int count) {
    const auto any = [&](std::size_t size) { return static_cast<int>(random() % size); };
    for (int i = 0; i < count; ++i) {
        Triangle& t = soup.triangles[any(soup.triangles.size())];
        switch (random() % 5) {
            case 0:
                std::swap(t[0], t[1]);
                break;
            case 1:
                t[any(3)] = any(soup.positions.size());
                break;
            case 2:
                soup.triangles.push_back(Triangle(t));
                break;
            case 3:
                soup.positions[any(soup.positions.size())] = soup.positions[t[0]];
                break;
            default:
                t = soup.triangles.back();
                soup.triangles.pop_back();
                break;
        }
    }
}

}  // namespace kerf::test
