#pragma once
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

/// One collision that is not round: the matter of seeded hot spots expands with longitudinal scaling.
namespace sph::transverse {

struct EventScene {
    long spots = 20;         ///< Gaussians of width 1 at random places of the disc r < 5, alike
    std::uint64_t seed = 1;  ///< of the places
    std::size_t n = 5000;    ///< particles of the disc r < 9
    double tau0 = 1;
    std::vector<double> times;  ///< increasing, >= tau0: when frames are taken
    double courant = 0.7;
    int threads = 1;
    std::function<void(double share)> progress{};
    static constexpr double disc = 5, width = 1, reach = 9;
};

struct EventFrame {
    double time = 0;
    Column x, y, temperature, u_x, u_y;
};
struct EventRun {
    std::vector<EventFrame> frames;
    /// eps_n = |sum nu r^n e^(i n phi)|/sum nu r^n about the centre of entropy, at tau0, for n = 2, 3.
    std::array<double, 2> eccentricity{};
    /// v_n = |sum nu |q| e^(i n phi_q)|/sum nu |q|, phi_q the angle of the momentum, at the end.
    std::array<double, 2> flow{};
    double momentum = 0;  ///< as in Snapshot
    double seconds = 0;
    Counters counters;
};
/// By the recommended method's force and h; the mean of s over the disc of the spots is 1 at the start.
EventRun run_event(const EventScene& scene);

class EventCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    double time_ = 8;
    long spots_ = 20, particles_ = 5000;
};

}  // namespace sph::transverse
