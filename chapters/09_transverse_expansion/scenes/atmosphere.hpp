#pragma once
#include <functional>
#include <vector>

#include "common/core/integrated.hpp"
#include "common/report/chapter.hpp"

/// A fluid that hangs at rest in Rindler's coordinates, ds^2 = a^2 x^2 dt^2 - dx^2, between two walls at x =
/// 1 and x = 2: T sqrt(g_00) is constant, T = 1/x (Tolman), P = c0^2 eps.
namespace sph::transverse {

struct AtmosphereScene {
    std::size_t n = 100;  ///< particles between the walls, 10 and above
    double c2 = 1.0 / 3;
    double sign = -1;      ///< of the weight; 1 as (322) is printed
    double crossings = 3;  ///< how long it runs, in times of sound from wall to wall
    int samples = 60;      ///< of the motion
    double courant = 0.3;
    int threads = 1;
    static constexpr double bottom = 1, top = 2, a = 1;
    double crossing_time() const;  ///< ln(top/bottom)/(a c0)
};

struct Atmosphere {
    Column x, temperature, exact_temperature, v;  ///< of the free particles at the end, in order
    Column times, moved;                          ///< in crossings; largest |x - x(0)| over the height
    double l1_temperature = 0;
    double speed = 0;       ///< largest |v| in units of the sound's
    double settled = 0;     ///< largest force left at the start over the weight, at the corrected sign
    double mean_shift = 0;  ///< mean x - x(0) at the end over the height: above 0 is upwards
    double seconds = 0;
    Counters counters;
};

/// Particles of equal spacing, walls of held ones as far as h reaches, then moved to where the sums leave no
/// force at the corrected sign (Newton's method), and run from rest. Throws Unstable if the run leaves
/// physics, as it may at the printed sign; what it has seen until then is lost.
Atmosphere run_atmosphere(const AtmosphereScene& scene);

/// The scene `atmosphere` of the reader's own.
class AtmosphereCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    long particles_ = 100;
    double time_ = 3, c2_ = 1.0 / 3, courant_ = 0.3;
    bool printed_ = false;
};

}  // namespace sph::transverse
