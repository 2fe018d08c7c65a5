#pragma once
#include "chapters/07_godunov_sph/scenes/wedge.hpp"

/// The reader's own wedge.
namespace sph::godunov {

/// The Mach number of a flow as colours, with contours from 0.46 to 0.985 of the entering one by 0.025 (the
/// paper's 0.92 to 1.97 by 0.05 at Mach 2), and the wedge in grey.
void draw_mach(plot::Panel& panel, const WedgeChannel& channel, const ChannelFlow& flow, bool bar);

/// Leaves rows of results.csv, profile.csv (x,y,rho,v_x,v_y,p,mach) and the figure "wedge".
class WedgeCommand {
  public:
    WedgeCommand();
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    report::MethodOptions<ChannelMethod> method_;
    WedgeScene scene_;
    long cells_ = 32;
    std::string walls_ = "mirrors";
};

}  // namespace sph::godunov
