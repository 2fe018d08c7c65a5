#pragma once
#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// Hard cases: which methods finish them, with even and with disordered particles.
namespace sph {

struct HardCase {
    std::string name;
    TubeScene scene;
    bool blast_waves = false;  ///< Woodward & Colella's, between walls
};
/// Toro's five tests (2009, table 4.1; the second is the 123 problem, after Sjoegreen), a vacuum on one side,
/// an expansion at Mach 20, Noh's problem and cold flows that collide at Mach 1e4, the blast with a pressure
/// ratio of 3e10, Le Blanc's tube, Woodward & Colella's blast waves. Times as long as it takes for all waves
/// to form: what fails, fails early.
const std::vector<HardCase>& hard_cases();

/// Jitter 0 once, 0.1 and 0.3 with two seeds each.
struct Disorder {
    double jitter;
    unsigned long seed;
};
const std::vector<Disorder>& disorders();

/// Runs it with n particles. Returns "" if it finishes (ordered particles, positive energies), or the message
/// of the error that stopped it.
std::string survive(const HardCase& hard, const Method& method, std::size_t n, const Disorder& disorder,
                    int threads);

}  // namespace sph
