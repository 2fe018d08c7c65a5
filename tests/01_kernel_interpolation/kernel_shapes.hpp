#pragma once
#include <complex>
#include <string>
#include <vector>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "common/core/tile.hpp"

/// Kernels without their types, so that each check is compiled once and not for thirty kernels.
namespace shapes {

using Complex = std::complex<double>;

struct Shape {
    std::string name;
    int dimension = 1;
    double support = 0, sigma = 0;
    std::vector<double> joints{};
    // of q
    double (*w)(double) = nullptr;
    double (*f)(double) = nullptr;
    double (*dw)(double) = nullptr;
    double (*d2w)(double) = nullptr;
    Complex (*complex_w)(Complex) = nullptr;
    Complex (*complex_dw)(Complex) = nullptr;
    // of r and h
    double (*W)(double, double) = nullptr;
    double (*F)(double, double) = nullptr;
    double (*dW_dr)(double, double) = nullptr;
    double (*d2W_dr2)(double, double) = nullptr;
    double (*dW_dh)(double, double) = nullptr;
    Complex (*complex_W)(Complex, double) = nullptr;
    Complex (*complex_dW_dr)(Complex, double) = nullptr;
    // of eight r, of one h: W, F, d2W_dr2, dW_dh
    std::vector<sph::Tile> (*tiles)(const sph::Tile&, double) = nullptr;

    bool is_super() const { return name == "super-gaussian"; }
    bool is_gaussian() const { return name.find("gaussian") != std::string::npos; }
    std::string title() const { return name + " in " + std::to_string(dimension) + "D"; }
};

template <class K>
Shape shape_of(K) {
    Shape shape{.name = std::string{K::name},
                .dimension = K::dimension,
                .support = K::support,
                .sigma = K::sigma,
                .joints = {K::joints.begin(), K::joints.end()}};
    shape.w = [](double q) { return K::w(q); };
    shape.f = [](double q) { return K::f(q); };
    shape.dw = [](double q) { return K::dw(q); };
    shape.d2w = [](double q) { return K::d2w(q); };
    shape.complex_w = [](Complex q) { return K::w(q); };
    shape.complex_dw = [](Complex q) { return K::dw(q); };
    shape.W = [](double r, double h) { return K::W(r, h); };
    shape.F = [](double r, double h) { return K::F(r, h); };
    shape.dW_dr = [](double r, double h) { return K::dW_dr(r, h); };
    shape.d2W_dr2 = [](double r, double h) { return K::d2W_dr2(r, h); };
    shape.dW_dh = [](double r, double h) { return K::dW_dh(r, h); };
    shape.complex_W = [](Complex r, double h) { return K::W(r, h); };
    shape.complex_dW_dr = [](Complex r, double h) { return K::dW_dr(r, h); };
    shape.tiles = [](const sph::Tile& r, double h) {
        return std::vector<sph::Tile>{K::W(r, h), K::F(r, h), K::d2W_dr2(r, h), K::dW_dh(r, h)};
    };
    return shape;
}

/// Every kernel of the chapter in every dimension, and the quadratic spline, which chapter 4 uses.
inline const std::vector<Shape>& all() {
    static const std::vector<Shape> shapes = [] {
        std::vector<Shape> list;
        const auto add = [&](const auto& kernel) { list.push_back(shape_of(kernel)); };
        sph::for_each_kernel<1>(add);
        sph::for_each_kernel<2>(add);
        sph::for_each_kernel<3>(add);
        add(sph::QuadraticSpline<1>{});
        add(sph::QuadraticSpline<2>{});
        add(sph::QuadraticSpline<3>{});
        return list;
    }();
    return shapes;
}

}  // namespace shapes
