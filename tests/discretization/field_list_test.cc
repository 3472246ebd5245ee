#include <rift/discretization/field_list.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  using Names = std::vector<std::string>;

  /** One field of each kind. */
  FieldList
  some_fields()
  {
    FieldList list;
    list.add("heat", "K", FieldLocation::node, [](const std::size_t node) {
      return 2. * node;
    });
    list.add(
      "flux",
      "W/m^2",
      FieldLocation::cell,
      [](const std::size_t cell) {
        return Vector3<double>{{1. * cell, 5, 6}};
      },
      FieldUse::on_request);
    list.add("strain", "", FieldLocation::cell, [](std::size_t) {
      return std::array<double, 6>{{1, 2, 3, 4, 5, 6}};
    });
    list.add_of_material("weight", "N", [](const std::string &material) {
      std::array<ExactSum, 3> sums;
      sums[1].add(static_cast<double>(material.size()));
      return sums;
    });
    return list;
  }

  const Field &
  field(const FieldList    &list,
        const std::string  &name,
        const FieldLocation location)
  {
    const Field *found = list.find(name, location);
    if (found == nullptr)
      throw std::logic_error("no field " + name);
    return *found;
  }
} // namespace

TEST(FieldList, ComponentsFollowFromTheValue)
{
  const FieldList list   = some_fields();
  const Field    &heat   = field(list, "heat", FieldLocation::node);
  const Field    &flux   = field(list, "flux", FieldLocation::cell);
  const Field    &strain = field(list, "strain", FieldLocation::cell);
  EXPECT_EQ(heat.components, Names{""});
  EXPECT_EQ(flux.components, (Names{"x", "y", "z"}));
  EXPECT_EQ(strain.components, (Names{"xx", "yy", "zz", "yz", "xz", "xy"}));

  std::array<double, 6> values{};
  heat.values(21, values.data());
  EXPECT_EQ(values, (std::array<double, 6>{{42, 0, 0, 0, 0, 0}}));
  flux.values(7, values.data());
  EXPECT_EQ(values, (std::array<double, 6>{{7, 5, 6, 0, 0, 0}}));
  strain.values(0, values.data());
  EXPECT_EQ(values, (std::array<double, 6>{{1, 2, 3, 4, 5, 6}}));

  const Field &weight = field(list, "weight", FieldLocation::material);
  EXPECT_EQ(weight.sum("steel", 0).value(), 0);
  EXPECT_EQ(weight.sum("steel", 1).value(), 5);
}

TEST(FieldList, IsFoundByNameAndPlace)
{
  const FieldList list = some_fields();
  EXPECT_EQ(list.find("heat", FieldLocation::cell), nullptr);
  EXPECT_EQ(list.find("head", FieldLocation::node), nullptr);
  EXPECT_EQ(title("flux", "W/m^2"), "flux [W/m^2]");
  EXPECT_EQ(title("strain", ""), "strain");
}

TEST(FieldList, Selections)
{
  const FieldList list     = some_fields();
  const auto      selected = [&](const Names &words) {
    Names names;
    for (const Field &f : list)
      if (FieldSelection{words}.includes(f))
        names.push_back(f.name);
    return names;
  };
  EXPECT_EQ(selected({"default"}), (Names{"heat", "strain"}));
  EXPECT_EQ(selected({"default", "flux"}), (Names{"heat", "flux", "strain"}));
  EXPECT_EQ(selected({"strain", "weight"}), (Names{"strain", "weight"}));
  EXPECT_EQ(selected({"all"}), (Names{"heat", "flux", "strain", "weight"}));
  EXPECT_TRUE(selected({}).empty());
}

TEST(FieldList, NodalFields)
{
  State state;
  state.resize(1);
  state.displacement[0][1] = .25;
  state.velocity[0][2]     = 3;
  state.velocity[0][0]     = -3;
  state.force[0][2]        = 8;
  state.mass[0]            = 2;
  FieldList list(state, .5);
  declare_nodal_fields(list);
  Vector3<double> value;
  field(list, "displacement", FieldLocation::node).values(0, value.data());
  EXPECT_EQ(value, (Vector3<double>{{0, .25, 0}}));
  // Half a kick on: 3 + 8/2 * .25
  field(list, "velocity", FieldLocation::node).values(0, value.data());
  EXPECT_EQ(value, (Vector3<double>{{-3, 0, 4}}));
  field(list, "speed", FieldLocation::node).values(0, value.data());
  EXPECT_EQ(value[0], 5);
}
