#pragma once
#include <map>
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// The scene `tube` of the reader's own: two states, any method, and what may be turned at it.
namespace sph::shocks {

/// What a tube of some kind of gas has of its own.
struct TubeKind {
    const Methods<1>& methods;
    TubeScene defaults;
    app::Range gamma;                                      ///< allowed
    std::function<TubeProblem(const TubeScene&)> problem;  ///< throws std::invalid_argument for what is none
    std::function<report::Quantities(const TubeScene&, const TubeRun&)> more{};  ///< further rows
    /// The ways to give a velocity, "v" among them, and what makes v of it, which throws std::domain_error
    /// for a number that is none. Empty: as v only.
    std::map<std::string, std::function<double(double)>> velocities{};
    std::map<std::string, std::function<double(double v)>> columns{};  ///< further ones of profile.csv
};

/// Leaves rows of results.csv, profile.csv (x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u) and the figure
/// "tube".
class TubeCommand {
  public:
    TubeCommand();  // of an ideal gas
    explicit TubeCommand(TubeKind kind);
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    TubeScene scene(const report::Run& run) const;

    TubeKind kind_;
    report::MethodOptions<Method<1>> method_;
    std::vector<double> left_, right_, window_;
    double gamma_, time_, jitter_ = 0, courant_, diaphragm_;
    long particles_;
    std::string spacing_ = "masses", velocity_ = "v";
};

}  // namespace sph::shocks
