#include "sim/base/predicates.h"

namespace kerf {

namespace {

// In doubled precision: some tens of roundings of 2^-104, with much room.
constexpr double kFilterDoubled = 1e-29;

struct TwoTerms {
    double high;
    double low;
};

TwoTerms exactSum(double a, double b) {
    const double sum = a + b;
    const double bRounded = sum - a;
    return {sum, (a - (sum - bRounded)) + (b - bRounded)};
}

TwoTerms exactProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// A number as a sum of doubles that do not overlap, smallest first, zeros left out.
template <int Capacity>
struct Expansion {
    std::array<double, Capacity> terms;
    int count = 0;

    void add(double b) {
        double carry = b;
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            const TwoTerms sum = exactSum(carry, terms[i]);
            if (sum.low != 0) {
                terms[kept++] = sum.low;
            }
            carry = sum.high;
        }
        if (carry != 0) {
            terms[kept++] = carry;
        }
        count = kept;
    }

    int sign() const { return count == 0 ? 0 : (terms[count - 1] > 0 ? 1 : -1); }

    double value() const {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            sum += terms[i];
        }
        return sum;
    }
};

Expansion<2> difference(double a, double b) {
    const TwoTerms terms = exactSum(a, -b);
    Expansion<2> result;
    result.add(terms.low);
    result.add(terms.high);
    return result;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& x, const Expansion<M>& y) {
    Expansion<2 * N * M> result;
    for (int i = 0; i < x.count; ++i) {
        for (int j = 0; j < y.count; ++j) {
            const TwoTerms product = exactProduct(x.terms[i], y.terms[j]);
            result.add(product.low);
            result.add(product.high);
        }
    }
    return result;
}

template <int N, int M>
Expansion<N + M> combine(const Expansion<N>& x, const Expansion<M>& y, double signOfY) {
    Expansion<N + M> result;
    for (int i = 0; i < x.count; ++i) {
        result.add(x.terms[i]);
    }
    for (int j = 0; j < y.count; ++j) {
        result.add(signOfY * y.terms[j]);
    }
    return result;
}

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& x, const Expansion<M>& y) {
    return combine(x, y, 1.0);
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& x, const Expansion<M>& y) {
    return combine(x, y, -1.0);
}

Orientation exactOrient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const auto ux = difference(b.x(), a.x());
    const auto uy = difference(b.y(), a.y());
    const auto uz = difference(b.z(), a.z());
    const auto vx = difference(c.x(), a.x());
    const auto vy = difference(c.y(), a.y());
    const auto vz = difference(c.z(), a.z());
    const auto determinant = (uy * vz - uz * vy) * difference(p.x(), a.x()) +
                             (uz * vx - ux * vz) * difference(p.y(), a.y()) +
                             (ux * vy - uy * vx) * difference(p.z(), a.z());
    return {determinant.sign(), determinant.value()};
}

// Twice the precision of a double (Dekker 1971), for the sign of sums of products.

TwoTerms normalized(double high, double low) {
    const double sum = high + low;
    return {sum, low - (sum - high)};
}

TwoTerms doubledDifference(const TwoTerms& x, const TwoTerms& y) {
    const TwoTerms high = exactSum(x.high, -y.high);
    return normalized(high.high, high.low + (x.low - y.low));
}

TwoTerms doubledSum(const TwoTerms& x, const TwoTerms& y) {
    const TwoTerms high = exactSum(x.high, y.high);
    return normalized(high.high, high.low + (x.low + y.low));
}

TwoTerms doubledProduct(const TwoTerms& x, const TwoTerms& y) {
    const TwoTerms high = exactProduct(x.high, y.high);
    return normalized(high.high, high.low + (x.high * y.low + x.low * y.high));
}

/// 0 where this precision does not tell.
int doubledSign3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, double magnitude) {
    std::array<TwoTerms, 3> u, v, w;
    for (int i = 0; i < 3; ++i) {
        u[i] = exactSum(b[i], -a[i]);
        v[i] = exactSum(c[i], -a[i]);
        w[i] = exactSum(p[i], -a[i]);
    }
    TwoTerms sum{0, 0};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const TwoTerms minor =
            doubledDifference(doubledProduct(u[j], v[k]), doubledProduct(u[k], v[j]));
        sum = doubledSum(sum, doubledProduct(minor, w[i]));
    }
    const double error = kFilterDoubled * magnitude;
    return sum.high > error ? 1 : sum.high < -error ? -1 : 0;
}

}  // namespace

Orientation orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Estimate3d estimate = estimate3d(a, b, c, p);
    const int sign = estimate.sign();
    return sign != 0 ? Orientation{sign, estimate.determinant} : exactOrient3d(a, b, c, p);
}

int preciseSign3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, double magnitude) {
    const int sign = doubledSign3d(a, b, c, p, magnitude);
    return sign != 0 ? sign : exactOrient3d(a, b, c, p).sign;
}

int exactOrient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    const auto determinant = difference(b.x(), a.x()) * difference(c.y(), a.y()) -
                             difference(b.y(), a.y()) * difference(c.x(), a.x());
    return determinant.sign();
}

bool comesBefore(const Vec3& p, int idP, const Vec3& q, int idQ) {
    for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] != q[axis]) {
            return p[axis] < q[axis];
        }
    }
    return idP < idQ;
}

}  // namespace kerf
