#pragma once
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/report/chapter.hpp"

/// What every tube of the reader's own takes and leaves, whatever gas is in it.
namespace sph {

/// The three numbers of --left or --right. Throws app::UsageError for a density or pressure below 0, or where
/// only one of them is 0.
exact::Riemann::State tube_state(const std::string& option, const std::vector<double>& values);

/// The method of that name; the last, which is the recommended one, where `name` is empty. Throws
/// app::UsageError, which names those that there are.
const Method& choose_method(const std::string& name, const std::vector<Method>& methods);
/// Their names, a line each.
std::string method_list(const std::vector<Method>& methods);

/// Rows of results.csv, profile.csv (x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u) and the figure "tube".
/// `line`: the exact solution, to be drawn.
void report_tube(report::Run& run, const std::string& method, long n, const TubeRun& tube,
                 const Profile& line);

}  // namespace sph
