#include <rift/cohesive/fracture.h>

#include <memory>

// What output can show of open faces.
namespace rift
{
  void
  Fracture::declare_fields(FieldList &list, const Fracture *fracture)
  {
    // The means of all faces are computed together when the first is asked for.
    const auto all = std::make_shared<std::vector<FaceMeans>>();
    const auto add = [&](const char *name,
                         const char *unit,
                         double (*value)(const FaceMeans &)) {
      list.add(
        name,
        unit,
        FieldLocation::cohesive_face,
        [fracture, state = list.state(), all, value](const std::size_t i) {
          if (all->empty())
            *all = fracture->means(*state);
          return value((*all)[i]);
        });
    };
    add("damage", "", [](const FaceMeans &f) { return f.damage; });
    add("mode", "", [](const FaceMeans &f) { return f.mode(); });
    add("opening", "m", [](const FaceMeans &f) { return f.opening; });
    add("slip", "m", [](const FaceMeans &f) { return f.slip; });
    add("normal traction", "Pa", [](const FaceMeans &f) { return f.normal; });
    add("shear traction", "Pa", [](const FaceMeans &f) { return f.shear; });
    add("time of insertion", "s", [](const FaceMeans &f) {
      return f.start_time;
    });
    add("time of failure", "s", [](const FaceMeans &f) {
      return f.failure_time;
    });
  }
} // namespace rift
