#ifndef rift_cohesive_laws_law_values_h
#define rift_cohesive_laws_law_values_h

namespace rift
{
  /** What comparisons of numbers give: bool or SimdMask. */
  template <typename Number>
  using MaskOf = decltype(Number{} > Number{});

  /** Energy per area that one update of a law has used up, J/m^2. */
  template <typename Number>
  struct Dissipation
  {
    /** By fracture and by friction. */
    Number fracture, friction;
  };

  /**
   * Elastic energy per area that comes with the traction with which a face
   * starts, J/m^2. It has not been drawn from the body.
   */
  struct InitialEnergy
  {
    /** Of tension and of the shear that the cohesion carries, which fracture
     * uses up, and of pressure and friction. */
    double cohesive, frictional;
  };

  /**
   * The two parts of the damage of a point. D = sqrt(opening^2 + slip^2) rises
   * from 0, intact, to 1, separated; it may be more than 1.
   */
  template <typename Number>
  struct Damage
  {
    /** By opening and by sliding. */
    Number opening, slip;
  };
} // namespace rift

#endif
