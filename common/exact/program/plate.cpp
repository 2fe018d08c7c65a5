#include "common/exact/plate.hpp"

#include <stdexcept>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

/// What both solutions take.
struct Bent {
    double thickness = 1, length = 10, young = 1, poisson = 0.3;
    std::string plane = "strain";

    static app::Range scale() { return {ClampedPlate::least_scale, ClampedPlate::largest_scale}; }
    void declare(app::CommandLine& command) {
        command.number("thickness", thickness, scale(), "length", "H, of the plate");
        command.number("length", length, scale(), "length", "L, from the clamp to the free end");
        command.number("young", young, scale(), "pressure", "E, Young's modulus");
        command.number("poisson", poisson, {-0.999, 0.5}, "", "nu, Poisson's ratio");
        command.choice("plane", plane, {"strain", "stress"},
                       "strain: a wide plate, E/(1 - nu^2) resists; stress: a narrow beam, E resists");
    }
    Plane chosen() const { return plane == "strain" ? Plane::strain : Plane::stress; }
    void tell(Csv& csv) const {
        csv.parameter("thickness", thickness).parameter("length", length).parameter("young", young);
        csv.parameter("poisson", poisson);
        csv.parameter("bending_stiffness", bending_stiffness(thickness, young, poisson, chosen()));
    }
};

class PlateSolution : public Solution {
  public:
    std::string name() const override { return "plate"; }
    std::string description() const override {
        return "frequencies of a thin plate that is clamped at one end and free at the other: mode,omega";
    }
    void declare(app::CommandLine& command) override {
        bent_.declare(command);
        command.number("density", density_, Bent::scale(), "mass/length^3", "rho");
        command.integer("modes", modes_, 1, ClampedPlate::largest_mode, "frequencies of modes 1 to N");
        command.footer("Example: exact plate --thickness 1 --length 10 --young 1 --poisson 0.4 --modes 5");
    }
    std::string csv(const app::CommandLine&) const override {
        const ClampedPlate plate{bent_.thickness, bent_.length, bent_.young,
                                 bent_.poisson,   density_,     bent_.chosen()};
        Csv csv;
        bent_.tell(csv);
        csv.parameter("density", density_).columns("mode,omega");
        for (int mode = 1; mode <= modes_; ++mode) csv.row({static_cast<double>(mode), plate.omega(mode)});
        return csv.text();
    }

  private:
    Bent bent_;
    double density_ = 1;
    long modes_ = 5;
};

class BeamSolution : public Solution {
  public:
    std::string name() const override { return "beam"; }
    std::string description() const override {
        return "deflection of a beam that is clamped at one end and loaded at the other: x,deflection";
    }
    void declare(app::CommandLine& command) override {
        bent_.declare(command);
        command.number("load", load_, {-ClampedPlate::largest_scale, ClampedPlate::largest_scale},
                       "pressure length", "w, the force on the end by depth");
        points_.declare(command, "positions, 0 to the length");
        command.footer("Example: exact beam --length 10 --load 1e-6 --points 11 --window 0,10");
    }
    std::string csv(const app::CommandLine& command) const override {
        const LoadedBeam beam{bent_.thickness, bent_.length, bent_.young,
                              bent_.poisson,   load_,        bent_.chosen()};
        Csv csv;
        bent_.tell(csv);
        csv.parameter("load", load_).parameter("end_deflection", beam.deflection(bent_.length));
        csv.columns("x,deflection");
        for (const double x : points_.values(command)) {
            if (x < 0 || x > bent_.length)
                throw app::UsageError{"--x: " + std::to_string(x) + " lies outside 0.." +
                                      std::to_string(bent_.length) + ", the beam"};
            csv.row({x, beam.deflection(x)});
        }
        return csv.text();
    }

  private:
    Bent bent_;
    double load_ = 1e-6;
    Points points_{"x", app::any, {0, 10}};
};

}  // namespace

std::unique_ptr<Solution> plate() {
    return std::make_unique<PlateSolution>();
}
std::unique_ptr<Solution> beam() {
    return std::make_unique<BeamSolution>();
}

}  // namespace exact::program
