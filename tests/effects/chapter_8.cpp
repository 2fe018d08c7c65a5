// The effects of chapter 8: those of chapters 1, 3 and 4 under other names, and exchanges of baryons.
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_8() {
    using enum Along;
    using enum Weight;
    const auto pushes = antisymmetric(mass, apart);
    return {
        of_kernel(OfEntropy::Counted<SummedDensity>{}, {symmetric(entropy, positive)}),
        of_kernel(OfEntropy::Counted<DensitySlope>{}, {symmetric(entropy, nothing)}),
        of_gradients(OfEntropy::Counted<PressureForce<>>{}, {antisymmetric(entropy, apart)}),
        of_gradients(OfEntropy::Counted<GradHForce>{}, {antisymmetric(entropy, apart)}),
        of_kernel(OfBaryons::Counted<SummedDensity>{}, {symmetric(mass, positive)}),
        of_gradients(OfBaryons::Counted<PressureForce<>>{}, {pushes}),
        of_gradients(OfBaryons::Counted<GradHForce>{}, {pushes}),
        of_gradients(OfBaryons::Counted<SlopeMatrix>{}, {symmetric_in_one_kernel(lab_volume, positive)}),
        of_gradients(OfBaryons::Counted<SlopeSum<Rapidity>>{},
                     {symmetric_in_one_kernel(lab_volume, uphill_y)}),
        of_gradients(OfBaryons::Counted<SlopeSum<Pressure>>{},
                     {symmetric_in_one_kernel(lab_volume, uphill_p)}),
        of_gradients(GradHWork{}, {antisymmetric(mass, nothing)}),
        of_gradients<1>(ChowMonaghan{}, {antisymmetric(mass, more_q), antisymmetric(mass, more_E)}),
        of_gradients<1>(ReconstructedExchange{},
                        {pushes, antisymmetric(mass, nothing), symmetric(mass, positive)}),
        of_gradients<1>(ContactConduction{}, {antisymmetric(mass, nothing), antisymmetric(mass, more_u)}),
        of_gradients<1>(LabSignalRate{}, {symmetric(one, positive)}),
    };
}

const std::vector<Subject>& all_subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> found;
        for (const auto& chapter : {chapters_1_and_2(), chapter_3(), chapter_4(), chapter_5(),
                                    chapter_5_cures(), chapter_6(), chapter_7(), chapter_8(), chapter_9()})
            found.insert(found.end(), chapter.begin(), chapter.end());
        return found;
    }();
    return all;
}

}  // namespace sph::tested
