#include "chapters/01_kernel_interpolation/scenes/integral.hpp"

#include <gsl/gsl_integration.h>

#include <memory>

namespace sph::interpolation {

Quadrature quadrature_over(double support, const std::vector<double>& joints, int parts) {
    constexpr std::size_t nodes = 16;
    const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table{
        gsl_integration_glfixed_table_alloc(nodes), gsl_integration_glfixed_table_free};
    Quadrature result;
    std::vector<double> ends = joints;
    ends.push_back(support);
    double begin = 0;
    for (const double end : ends) {
        const double width = (end - begin) / parts;
        for (int part = 0; part < parts; ++part) {
            for (std::size_t n = 0; n < nodes; ++n) {
                double q = 0, weight = 0;
                gsl_integration_glfixed_point(begin + part * width, begin + (part + 1) * width, n, &q,
                                              &weight, table.get());
                result.q.push_back(q);
                result.weight.push_back(weight);
            }
        }
        begin = end;
    }
    return result;
}

}  // namespace sph::interpolation
