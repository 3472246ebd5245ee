#include <rift/cohesive/cohesive_elements_of.h>
#include <rift/cohesive/laws/all.h>

#include <stdexcept>

namespace rift
{
  namespace
  {
    template <typename... Laws, typename... Arguments>
    std::unique_ptr<CohesiveElements>
    make_elements(LawList<Laws...>,
                  const CohesiveParameters &parameters,
                  Arguments &...arguments)
    {
      std::unique_ptr<CohesiveElements> elements;
      const auto                        try_law = [&](auto *law) {
        using Law = std::remove_pointer_t<decltype(law)>;
        if (Law::name == parameters.chosen_law() &&
            Law::model == parameters.model)
          elements = std::make_unique<CohesiveElementsOf<Law>>(arguments...);
      };
      (try_law(static_cast<Laws *>(nullptr)), ...);
      return elements;
    }
  } // namespace

  std::string
  CohesiveParameters::chosen_law() const
  {
    if (law != automatic || model == Model::none)
      return law;
    return model == Model::extrinsic ? bonds :
                                       MohrCoulomb<ParabolicBranch>::name;
  }

  std::unique_ptr<CohesiveElements>
  make_cohesive_elements(const CohesiveParameters &parameters,
                         CohesiveFaces            &faces,
                         const Topology           &topology,
                         const FaceStrengths      &strengths,
                         PenaltyStiffness          stiffness_of)
  {
    auto elements = make_elements(CohesiveLaws(),
                                  parameters,
                                  faces,
                                  topology,
                                  strengths,
                                  stiffness_of);
    if (!elements)
      throw std::logic_error("no cohesive law \"" + parameters.chosen_law() +
                             "\" for this model");
    return elements;
  }
} // namespace rift
