#include <rift/cohesive/cohesive_force.h>

#include <cmath>
#include <limits>
#include <memory>

namespace rift
{
  namespace
  {
    /** What is written of a cohesive face; means over its Gauss points. */
    struct FaceValues
    {
      double damage = 0, opening = 0, slip = 0, normal = 0, shear = 0;
      double opening_damage = 0, slip_damage = 0;
      double insertion_time = 0, failure_time = 0;

      /** Share of sliding in the damage, from 0 to 1. */
      double
      mode() const
      {
        const double total = opening_damage + slip_damage;
        return total > 0 ? slip_damage / total : 0;
      }
    };

    FaceValues
    face_values(const CohesiveForce &force,
                const State         &state,
                const std::size_t    index)
    {
      static const FaceQuadrature quadrature;
      const CohesiveFaceInfo     &info = force.faces().infos[index];
      FaceValues                  values;
      values.insertion_time = info.start_time;
      values.failure_time   = info.failure_time;
      for (unsigned int q = 0; q < n_face_points; ++q)
        {
          const double weight = quadrature.weight[q];
          const auto   now    = force.point_state(state, index, q);
          values.damage += weight * now.damage;
          values.opening_damage += weight * now.opening * now.opening;
          values.slip_damage += weight * now.slip * now.slip;
          values.opening += weight * now.jump[0];
          values.slip += weight * std::hypot(now.jump[1], now.jump[2]);
          values.normal += weight * now.traction[0];
          values.shear += weight * std::hypot(now.traction[1], now.traction[2]);
        }
      return values;
    }
  } // namespace

  void
  CohesiveForce::declare_fields(FieldList &list, const CohesiveForce *force)
  {
    // All fields of a face are computed together, and asked for one by one.
    struct Latest
    {
      std::size_t index = std::numeric_limits<std::size_t>::max();
      FaceValues  values;
    };
    const auto latest = std::make_shared<Latest>();
    const auto add    = [&](const char *name,
                         const char *unit,
                         double (*value)(const FaceValues &)) {
      list.add(
        name,
        unit,
        FieldLocation::cohesive_face,
        [force, state = list.state(), latest, value](const std::size_t index) {
          if (latest->index != index)
            *latest = {index, face_values(*force, *state, index)};
          return value(latest->values);
        });
    };
    using Values = FaceValues;
    add("damage", "", [](const Values &v) { return v.damage; });
    add("mode", "", [](const Values &v) { return v.mode(); });
    add("opening", "m", [](const Values &v) { return v.opening; });
    add("slip", "m", [](const Values &v) { return v.slip; });
    add("normal traction", "Pa", [](const Values &v) { return v.normal; });
    add("shear traction", "Pa", [](const Values &v) { return v.shear; });
    add("time of insertion", "s", [](const Values &v) {
      return v.insertion_time;
    });
    add("time of failure", "s", [](const Values &v) { return v.failure_time; });
  }
} // namespace rift
