#pragma once
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

/// The scenes `cylinder` and `gubser` of the reader's own.
namespace sph::transverse {

/// What both have: a method, particles and a time; profile.csv and a figure.
class PlaneCommand {
  public:
    PlaneCommand();

  protected:
    void declare_common(app::CommandLine& line);
    /// Runs, records, writes and draws; `with_eps`: profile.csv has eps, too.
    void run_flow(report::Run& run, const Flow& flow, bool with_eps) const;
    bool listed(report::Run& run) const;

    double time_ = 0;

  private:
    report::MethodOptions<PlaneMethod> method_;
    double courant_ = 0.7;
    long particles_ = 10000;
};

class CylinderCommand : public PlaneCommand {
  public:
    CylinderCommand() { time_ = 15; }
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    double radius_ = 10, tau0_ = 1, c2_ = 1.0 / 3;
};

class GubserCommand : public PlaneCommand {
  public:
    GubserCommand() { time_ = 1.5; }
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    double q_ = 1, tau0_ = 1;
};

}  // namespace sph::transverse
