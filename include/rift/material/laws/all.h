#ifndef rift_material_laws_all_h
#define rift_material_laws_all_h

#include <rift/material/laws/anisotropic.h>
#include <rift/material/laws/isotropic.h>
#include <rift/material/laws/microcracked.h>
#include <rift/material/laws/rigid.h>
#include <rift/material/laws/transversely_isotropic.h>

#include <tuple>
#include <variant>

namespace rift
{
  /** All elastic laws, the default first. To add one is to add its header and
   * its name here. */
  using ElasticLaws = std::tuple<IsotropicElasticity,
                                 AnisotropicElasticity,
                                 MicrocrackedElasticity,
                                 RigidElasticity,
                                 TransverselyIsotropicElasticity>;

  namespace internal
  {
    /** A variant of the types that come after it, each once. */
    template <typename Variant, typename... Types>
    struct Unique
    {
      using type = Variant;
    };

    template <typename... Known, typename Type, typename... Types>
    struct Unique<std::variant<Known...>, Type, Types...>
      : Unique<std::conditional_t<(std::is_same_v<Known, Type> || ...),
                                  std::variant<Known...>,
                                  std::variant<Known..., Type>>,
               Types...>
    {
    };

    template <typename Laws>
    struct StressOf;

    template <typename... Laws>
    struct StressOf<std::tuple<Laws...>>
      : Unique<std::variant<>,
               decltype(Laws::make(std::declval<MaterialParameters>()))...>
    {
    };
  } // namespace internal

  /** What computes the stress of one of the laws. */
  using Elasticity = typename internal::StressOf<ElasticLaws>::type;

  /** Calls f(law) for each law; the object has no meaning but its type. */
  template <typename Function>
  void
  for_each_elastic_law(const Function &f)
  {
    std::apply([&](const auto &...law) { (f(law), ...); }, ElasticLaws());
  }
} // namespace rift

#endif
