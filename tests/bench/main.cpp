// The micro-benchmarks: ./tutorial bench [NAME]. Results and figures: renders/bench/.
#include "tests/bench/benches.hpp"

int main(int argc, char** argv) {
    report::Chapter benches{report::Place{"bench", "./tutorial bench", "bench", "README.md"},
                            "How fast are the parts, beside the plain way to write them?", "none"};
    benches.figure("kernels", "nanoseconds a pair of every kernel, and of the cubic spline in five forms",
                   bench::kernels);
    return benches.main(argc, argv);
}
