#include <rift/cohesive/cohesive_force.h>

#include <memory>

// What output can show of cohesive faces.
namespace rift
{
  void
  CohesiveForce::declare_fields(FieldList &list, const CohesiveForce *force)
  {
    // The means of all faces are computed together when the first is asked for.
    struct Values
    {
      FaceMeans        means;
      CohesiveFaceInfo info;
    };
    const auto all = std::make_shared<std::vector<FaceMeans>>();
    const auto add = [&](const char *name,
                         const char *unit,
                         double (*value)(const Values &)) {
      list.add(name,
               unit,
               FieldLocation::cohesive_face,
               [force, state = list.state(), all, value](const std::size_t i) {
                 if (all->empty())
                   *all = force->means(*state);
                 return value({(*all)[i], force->faces().infos[i]});
               });
    };
    add("damage", "", [](const Values &v) { return v.means.damage; });
    add("mode", "", [](const Values &v) { return v.means.mode(); });
    add("opening", "m", [](const Values &v) { return v.means.opening; });
    add("slip", "m", [](const Values &v) { return v.means.slip; });
    add("normal traction", "Pa", [](const Values &v) {
      return v.means.normal;
    });
    add("shear traction", "Pa", [](const Values &v) { return v.means.shear; });
    add("time of insertion", "s", [](const Values &v) {
      return v.info.start_time;
    });
    add("time of failure", "s", [](const Values &v) {
      return v.info.failure_time;
    });
  }
} // namespace rift
