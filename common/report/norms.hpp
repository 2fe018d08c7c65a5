#pragma once
#include <span>
#include <vector>

namespace report {

using Span = std::span<const double>;

/// Relative errors against `exact` (same length, at least one value, exact not all zero; otherwise
/// std::invalid_argument). `weight` are the widths dx of the points; empty: all equal.
double l1_error(Span value, Span exact, Span weight = {});  ///< sum |f - e| dx / sum |e| dx
double l2_error(Span value, Span exact, Span weight = {});  ///< sqrt(sum (f - e)^2 dx / sum e^2 dx)
double linf_error(Span value, Span exact);                  ///< max |f - e| / max |e|

/// sqrt(sum |estimate - exact|^2 / sum |exact|^2) of values that come one by one, vectors component by
/// component.
class SquaredError {
  public:
    void add(double estimate, double exact) {
        error_ += (estimate - exact) * (estimate - exact);
        size_ += exact * exact;
    }
    double relative() const;

  private:
    double error_ = 0, size_ = 0;
};

/// Observed order between two resolutions: log(e1/e2) / log(n2/n1); all arguments > 0, n1 != n2.
double observed_order(double n1, double e1, double n2, double e2);
/// Least-squares slope of -log(error) against log(n): the observed order over several resolutions.
double fitted_order(Span n, Span error);

}  // namespace report
