#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

/// Vectors of d components, whatever these are: numbers, tiles of numbers, columns of numbers. With their
/// arithmetic an equation on a tile of pairs reads as it is printed.
namespace sph {

template <class T, int d>
struct Vec {
    T component[static_cast<std::size_t>(d)]{};

    constexpr T& operator[](std::size_t axis) { return component[axis]; }
    constexpr const T& operator[](std::size_t axis) const { return component[axis]; }
    static constexpr std::size_t size() { return static_cast<std::size_t>(d); }
    constexpr T* begin() { return component; }
    constexpr T* end() { return component + size(); }
    constexpr const T* begin() const { return component; }
    constexpr const T* end() const { return component + size(); }

    constexpr Vec& operator+=(const Vec& other) {
        for (std::size_t a = 0; a < size(); ++a) component[a] += other[a];
        return *this;
    }
    constexpr Vec& operator-=(const Vec& other) {
        for (std::size_t a = 0; a < size(); ++a) component[a] -= other[a];
        return *this;
    }
    friend bool operator==(const Vec&, const Vec&) = default;
};

template <class T>
struct IsVec : std::false_type {};
template <class T, int d>
struct IsVec<Vec<T, d>> : std::true_type {};

// A number and a tile mix: the result is a tile.
template <class T, class U, int d>
constexpr auto operator+(const Vec<T, d>& a, const Vec<U, d>& b) {
    Vec<decltype(a[0] + b[0]), d> result;
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] + b[k];
    return result;
}
template <class T, class U, int d>
constexpr auto operator-(const Vec<T, d>& a, const Vec<U, d>& b) {
    Vec<decltype(a[0] - b[0]), d> result;
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] - b[k];
    return result;
}
template <class T, int d>
constexpr Vec<T, d> operator-(const Vec<T, d>& a) {
    Vec<T, d> result;
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = -a[k];
    return result;
}
template <class S, class T, int d>
requires(!IsVec<S>::value) constexpr auto operator*(const S& factor, const Vec<T, d>& v) {
    Vec<decltype(factor * v[0]), d> result;
    for (std::size_t k = 0; k < v.size(); ++k) result[k] = factor * v[k];
    return result;
}

/// a . b
template <class T, class U, int d>
constexpr auto dot(const Vec<T, d>& a, const Vec<U, d>& b) {
    auto sum = a[0] * b[0];
    for (std::size_t k = 1; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

/// The tensor of all products a[k] b[l].
template <class T, int d>
constexpr Vec<Vec<T, d>, d> outer(const Vec<T, d>& a, const Vec<T, d>& b) {
    Vec<Vec<T, d>, d> result;
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] * b;
    return result;
}

using Column = std::vector<double>;
template <int d>
using Vector = Vec<double, d>;
/// One column per coordinate: x[axis][particle].
template <int d>
using Columns = Vec<Column, d>;

}  // namespace sph
