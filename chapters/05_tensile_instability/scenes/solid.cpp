#include "chapters/05_tensile_instability/scenes/solid.hpp"

#include "chapters/05_tensile_instability/scenes/solid_laws.hpp"

namespace sph::tensile {

const report::Methods<SolidMethod>& solid_methods() {
    static const report::Methods<SolidMethod> methods{
        "total-lagrangian",
        {{"jaumann", "as printed", Law::jaumann},
         {"artificial-stress", "artificial stress", Law::artificial_stress},
         {"strong-xsph", "strong XSPH", Law::xsph},
         {"corrected-rate", "corrected gradients", Law::corrected_rate},
         {"total-lagrangian", "total Lagrangian", Law::total_lagrangian, 0.75}}};
    return methods;
}

SolidMethod with_h(const std::string& name, const std::string& suffix, double h_over_dx) {
    SolidMethod method = solid_methods()[name];
    method.name += "-" + suffix;
    method.label += ", " + suffix;
    method.h_over_dx = h_over_dx;
    return method;
}

ConstantH<SolidKernel> smoothing_of(const SolidSetup& setup, const SolidMethod& method) {
    return {method.h_over_dx * setup.dx};
}

std::unique_ptr<Solid> make_solid(const SolidSetup& setup, const SolidMethod& method) {
    return method.law == Law::total_lagrangian ? make_lagrangian_solid(setup, method)
                                               : make_jaumann_solid(setup, method);
}

double angular_momentum(const Solid& solid) {
    const auto &x = solid.get<Position>(), &v = solid.get<Velocity>();
    const auto& m = solid.get<Mass>();
    double sum = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) sum += m[i] * (x[0][i] * v[1][i] - x[1][i] * v[0][i]);
    return sum;
}

Pieces pieces_of(const Columns<2>& x, double link) {
    const std::size_t n = x[0].size();
    std::vector<bool> seen(n);
    Pieces pieces;
    for (std::size_t first = 0; first < n; ++first) {
        if (seen[first]) continue;
        seen[first] = true;
        std::vector<std::size_t> piece{first};
        for (std::size_t k = 0; k < piece.size(); ++k) {
            for (std::size_t j = 0; j < n; ++j) {
                const double apart = std::hypot(x[0][piece[k]] - x[0][j], x[1][piece[k]] - x[1][j]);
                if (seen[j] || apart > link) continue;
                seen[j] = true;
                piece.push_back(j);
            }
        }
        ++pieces.count;
        pieces.largest = std::max(pieces.largest, piece.size());
    }
    return pieces;
}

Tensor<2> lattice_matrix(double h_over_dx, long rows) {
    const auto reach = static_cast<long>(SolidKernel::support * h_over_dx);
    Tensor<2> B{};
    for (long a = -reach; a <= reach; ++a) {
        for (long b = -reach; b <= std::min(rows, reach); ++b) {
            const Vector<2> x{static_cast<double>(a), static_cast<double>(b)};
            const double F = SolidKernel{}.F(Tile{std::sqrt(dot(x, x))}, h_over_dx)[0];
            B += outer(-F * x, x);
        }
    }
    return B;
}

}  // namespace sph::tensile
