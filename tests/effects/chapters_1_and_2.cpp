// The effects of chapters 1 and 2: estimates, by volume.
#include "chapters/02_consistency/discontinuity.hpp"
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapters_1_and_2() {
    using enum Along;
    using enum Weight;
    return {
        of_kernel(SummedDensity{}, {symmetric(mass, positive)}),
        of_kernel(Value{}, {neither(nothing, "of A_j only")}),
        of_kernel(PlainGradient{}, {neither(nothing, "of A_j only")}),
        of_kernel(DifferenceGradient{}, {symmetric(volume, uphill_A)}),
        of_kernel(DensityGradient{}, {neither(uphill_A, "the density of i only")}),
        of_kernel(TwiceDifferentiated{}, {neither(nothing, "of A_j only")}),
        of_kernel(Brookshaw{}, {antisymmetric(volume, more_A)}),
        of_kernel(TensorHessian{}, {antisymmetric(volume, more_A)}),
        of_kernel(ZerothMoment{}, {symmetric(volume, positive)}),
        of_kernel(FirstMoment{}, {antisymmetric(volume, apart)}),
        of_kernel(SecondMoment{}, {symmetric(volume, positive)}),
        of_kernel(CorrectionMatrix{}, {symmetric(volume, positive)}),
        of_kernel(WeightedDifferences{}, {symmetric(volume, uphill_A)}),
        of_kernel(FirstOfQuantity{}, {neither(nothing, "of A_j only")}),
        of_kernel<1>(CspmCurvature::Sums{}, {neither(nothing, "its components differ")}),
        of_kernel<1>(BeyondJump{.jump = {}}, {neither(nothing, "its components differ")}),
    };
}

}  // namespace sph::tested
