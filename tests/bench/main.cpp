// The micro-benchmarks: ./tutorial bench [NAME]. Results and figures: renders/bench/.
#include "tests/bench/benches.hpp"

int main(int argc, char** argv) {
    report::Chapter benches{report::Place{"bench", "./tutorial bench", "bench", "tests/bench/README.md"},
                            "How fast are the parts, beside the plain way to write them?", "none"};
    benches
        .timed_figure("kernels", "nanoseconds a pair of every kernel, and of the cubic spline in five forms",
                      bench::kernels)
        .timed_figure("pair_loop_2d", "pairs per second of a full set of forces in 2D, beside naive loops",
                      bench::pair_loop_2d)
        .timed_figure("pair_loop_3d", "the same in 3D", bench::pair_loop_3d)
        .timed_figure("effects", "effects listed at compile time, behind ifs, behind virtual calls",
                      bench::effects)
        .timed_figure("neighbours", "what finding neighbours costs", bench::neighbours)
        .timed_figure("scaling",
                      "whole steps in 3D, from a thousand to a million particles, on one thread and two",
                      bench::scaling);
    return benches.main(argc, argv);
}
