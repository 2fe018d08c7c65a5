#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/core/integrated.hpp"
#include "common/exact/transverse.hpp"
#include "common/report/chapter.hpp"

/// The cylinder on a line: rings of fluid, in the coordinates (tau, r).
namespace sph::transverse {

struct LineScene {
    exact::TransverseFlow flow{};
    std::size_t n = 400;          ///< rings in r < R
    std::vector<double> times{};  ///< increasing, above tau0
    double share = 1;             ///< of their entropy that the images behind the axis have: 1 or -1
    double h_over_dx = 1.8;       ///< in units of nu/s*
    double courant = 0.3;         ///< step over the shortest time in which sound crosses an h
    int threads = 1;
    std::function<void(double share)> progress{};
};

struct LineProfile {
    double time = 0;
    Column r, temperature, u_r, exact_temperature, exact_u_r;  ///< of the rings, in order
    double l1_temperature = 0;  ///< by area in r < R: sum |T - T_exact| dA/sum T_exact dA
    double axis = 0;            ///< largest |T/T_exact - 1| in r < R/20
    double inside = 0;          ///< and in R/20..R/2
    double entropy = 0;         ///< sum nu over tau0 R^2/2, less 1
    double seconds = 0;         ///< CPU time of the steps until here
    Counters counters;
    report::Quantities measured() const;
};

/// The flow at each of the times.
std::vector<exact::TransverseProfile> exact_lines(const exact::TransverseFlow& flow,
                                                  const std::vector<double>& times);

/// Runs RK4. Throws Unstable where the run leaves physics: rings that overtake each other included.
/// solutions: of exact_lines(), for callers that run several scenes at the same times.
std::vector<LineProfile> run_line(const LineScene& scene,
                                  const std::vector<exact::TransverseProfile>& solutions);
std::vector<LineProfile> run_line(const LineScene& scene);

/// Of n rings at rest with T = 1 in r < 1, h = 2 rings: the sum of the forces of all pairs over the sum of
/// their magnitudes. It vanishes if what i does to j is what j does to i. inside: of sqrt(-g) s u^0 = sum nu
/// W (314); else of s u^0 = sum_j nu_j W_j, with W_j = W/sqrt(-g)_j so that the integral of sqrt(-g) W_j is
/// one (315, 318).
double unpaired_force(std::size_t n, bool inside);

/// The scene `line` of the reader's own.
class LineCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    exact::TransverseFlow flow_{};
    long particles_ = 400;
    double time_ = 15, courant_ = 0.3, h_over_dx_ = 1.8;
    bool negative_ = false;
};

}  // namespace sph::transverse
