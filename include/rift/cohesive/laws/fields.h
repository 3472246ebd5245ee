#ifndef rift_cohesive_laws_fields_h
#define rift_cohesive_laws_fields_h

#include <rift/base/simd.h>

#include <tuple>
#include <type_traits>
#include <utility>

/**
 * @file
 *
 * The list of the members of a structure of numbers, from which everything that
 * has to visit all of them is made: access to a lane, checkpoints, comparisons.
 * Such a structure is a template on the number, `Number` or Vector3<Number> are
 * the types of its members, and it has
 *
 *     static constexpr auto
 *     fields()
 *     {
 *       return std::make_tuple(field("offset", &Point::offset), ...);
 *     }
 */
namespace rift
{
  /** A member and its name in checkpoints. */
  template <typename Structure, typename Member>
  struct PointField
  {
    /** Name in checkpoints, and the member. */
    const char *name;
    Member Structure::*member;
  };

  /** A PointField, its types deduced. */
  template <typename Structure, typename Member>
  constexpr PointField<Structure, Member>
  field(const char *name, Member Structure::*const member)
  {
    return {name, member};
  }

  /** Calls f(name, member) for each member of a structure. */
  template <typename Structure, typename Function>
  void
  for_each_field(Structure &structure, const Function &f)
  {
    std::apply(
      [&](const auto &...field) {
        (f(field.name, structure.*(field.member)), ...);
      },
      std::remove_const_t<Structure>::fields());
  }

  namespace internal
  {
    /** Calls f on two numbers, or on each component of two vectors. */
    template <typename A, typename B, typename Function>
    void
    for_each_component(A &a, B &b, const Function &f)
    {
      f(a, b);
    }

    template <typename A, typename B, typename Function>
    void
    for_each_component(Vector3<A> &a, Vector3<B> &b, const Function &f)
    {
      for (unsigned int d = 0; d < dim; ++d)
        f(a[d], b[d]);
    }

    template <typename A, typename B, typename Function>
    void
    for_each_component(Vector3<A> &a, const Vector3<B> &b, const Function &f)
    {
      for (unsigned int d = 0; d < dim; ++d)
        f(a[d], b[d]);
    }

    // Out of line, a law's update() would spill its registers here.
    template <typename A, typename B, typename Function, std::size_t... i>
    [[gnu::always_inline]] inline void
    for_each_number(A &a, B &b, const Function &f, std::index_sequence<i...>)
    {
      const auto of_a = std::remove_const_t<A>::fields();
      const auto of_b = std::remove_const_t<B>::fields();
      (for_each_component(a.*(std::get<i>(of_a).member),
                          b.*(std::get<i>(of_b).member),
                          f),
       ...);
    }
  } // namespace internal

  /** Calls f(number of a, number of b) for all numbers of two structures of the
   * same template, of which the second may be constant. */
  template <typename A, typename B, typename Function>
  [[gnu::always_inline]] inline void
  for_each_number(A &a, B &b, const Function &f)
  {
    constexpr std::size_t n_fields =
      std::tuple_size_v<decltype(std::remove_const_t<A>::fields())>;
    internal::for_each_number(a, b, f, std::make_index_sequence<n_fields>());
  }

  /** Whether fields() lists all members of a structure of double. */
  template <typename Numbers>
  constexpr bool
  has_all_fields()
  {
    return std::apply(
      [](const auto &...field) {
        return (sizeof(std::declval<Numbers>().*(field.member)) + ...) ==
               sizeof(Numbers);
      },
      Numbers::fields());
  }

  /** One lane of a structure of Simd, as a structure of double. */
  template <typename Numbers, typename Lanes>
  Numbers
  get_lane(const Lanes &lanes, const unsigned int lane)
  {
    Numbers result;
    for_each_number(result, lanes, [lane](double &number, const Simd &value) {
      number = value[lane];
    });
    return result;
  }

  /** Writes numbers to one lane; the opposite of get_lane(). */
  template <typename Lanes, typename Numbers>
  void
  set_lane(Lanes &lanes, const unsigned int lane, const Numbers &numbers)
  {
    for_each_number(lanes, numbers, [lane](Simd &value, const double number) {
      value[lane] = number;
    });
  }

  /** A structure of Simd that is the same in all lanes. */
  template <typename Lanes, typename Numbers>
  Lanes
  in_all_lanes(const Numbers &numbers)
  {
    Lanes result;
    for_each_number(result, numbers, [](Simd &value, const double number) {
      value = broadcast(number);
    });
    return result;
  }

  /** Takes a structure back to what it was, in the lanes that are not set. */
  template <typename Mask, typename Structure>
  [[gnu::always_inline]] inline void
  keep_unless(const Mask &mask, const Structure &old, Structure &now)
  {
    for_each_number(now, old, [&mask](auto &value, const auto &old_value) {
      value = select(mask, value, old_value);
    });
  }
} // namespace rift

#endif
