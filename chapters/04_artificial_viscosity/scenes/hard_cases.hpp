#pragma once
#include <functional>
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/methods.hpp"

/// Hard cases: which methods finish them and are right, with even and with disordered particles.
namespace sph::shocks {

/// How the particles begin.
struct Disorder {
    double jitter;
    unsigned long seed;
};
/// Jitter 0 once, 0.1 and 0.3 with two seeds each.
const std::vector<Disorder>& disorders();

struct HardCase {
    std::string name;
    /// Runs it with n particles and returns the relative L1 error of rho. Throws Unstable if the method does
    /// not finish: particles in order, positive energies, less than 6000 steps.
    std::function<double(const Method<1>& method, std::size_t n, const Disorder& disorder, int threads)> run;
};
/// Toro's five tests (2009, table 4.1; the second is the 123 problem, after Sjoegreen), a vacuum on one side,
/// an expansion at Mach 20, Noh's problem and cold flows that collide at Mach 1e4, the blast with a pressure
/// ratio of 3e10, Le Blanc's tube, Woodward & Colella's blast waves. Times as long as it takes for all waves
/// to form: what fails, fails early.
const std::vector<HardCase>& hard_cases();
/// Throws std::invalid_argument for a name that is none.
const HardCase& hard_case(const std::string& name);

}  // namespace sph::shocks
