#ifndef rift_discretization_field_list_h
#define rift_discretization_field_list_h

#include <rift/base/exact_sum.h>
#include <rift/discretization/state.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 *
 * The fields of a run by name, for output and probes. Who has a quantity
 * declares it with one call of FieldList::add(): its name, its unit, where it
 * lives, and how it is computed. Nobody else knows it.
 */
namespace rift
{
  /** What a field has values for. */
  enum class FieldLocation
  {
    /** Nodes; linear in the cells between them. */
    node,

    /** Cells. */
    cell,

    /** Cohesive elements, by their index in CohesiveFaces. */
    cohesive_face,

    /** All bodies of a rigid material together. */
    material
  };

  /** Whether a field is written without being asked for by name. */
  enum class FieldUse
  {
    by_default,
    on_request
  };

  /** A name with its unit: "velocity [m/s]". */
  inline std::string
  title(const std::string &name, const std::string &unit)
  {
    return unit.empty() ? name : name + " [" + unit + "]";
  }

  /** A field that output and probes can show, and how it is read. */
  struct Field
  {
    /** Name and SI unit, what it has values of, and when it is written. */
    std::string   name;
    std::string   unit;
    FieldLocation location;
    FieldUse      use;

    /** What its components are called; one without a name for a scalar. */
    std::vector<std::string> components;

    /** Writes the components for a node, a cell or a cohesive face. */
    std::function<void(std::size_t item, double *values)> values;

    /** For rigid materials: the part of this rank in a component. */
    std::function<ExactSum(const std::string &material, std::size_t component)>
      sum;
  };

  namespace internal
  {
    inline std::vector<std::string>
    component_names(const double *)
    {
      return {""};
    }

    inline std::vector<std::string>
    component_names(const Vector3<double> *)
    {
      return {"x", "y", "z"};
    }

    /** A symmetric tensor, in the order of SymmetricTensor. */
    inline std::vector<std::string>
    component_names(const std::array<double, 6> *)
    {
      return {"xx", "yy", "zz", "yz", "xz", "xy"};
    }
  } // namespace internal

  /**
   * Fields in the order in which they have been declared.
   *
   * A list with values is made for one moment: between the last force of a
   * step and the kick, when velocities at t_n can be computed. Its functions
   * look at the state and at the modules, and may be called until these
   * change. A list without a state has the names alone; a function that
   * declares fields can then be called without a module.
   */
  class FieldList
  {
  public:
    /** For names alone. */
    FieldList() = default;

    /** @param time_step s. */
    FieldList(const State &state, const double time_step)
      : the_state(&state)
      , dt(time_step)
    {
    }

    /** Null in a list of names alone. */
    const State *
    state() const
    {
      return the_state;
    }

    /** Length of the time step, s; zero in a list of names alone. */
    double
    time_step() const
    {
      return dt;
    }

    /**
     * Declares a field of nodes, cells or cohesive faces.
     *
     * @param value called with an index (std::size_t), returns the value of that
     *   item in SI units: a double, a Vector3<double> or a symmetric tensor
     *   (std::array of six, xx yy zz yz xz xy).
     */
    template <typename Function>
    Field &
    add(const std::string  &name,
        const std::string  &unit,
        const FieldLocation location,
        const Function     &value,
        const FieldUse      use = FieldUse::by_default)
    {
      using Value =
        std::decay_t<std::invoke_result_t<const Function &, std::size_t>>;
      const auto write = [value](const std::size_t item, double *values) {
        const Value result = value(item);
        if constexpr (std::is_same_v<Value, double>)
          *values = result;
        else
          std::copy(result.begin(), result.end(), values);
      };
      fields.push_back(
        {name,
         unit,
         location,
         use,
         internal::component_names(static_cast<Value *>(nullptr)),
         write,
         {}});
      return fields.back();
    }

    /**
     * Declares a vector that rigid materials have.
     *
     * @param parts called with the name of a material, returns the part of this
     *   rank in the components, as ExactSum.
     */
    template <typename Function>
    void
    add_of_material(const std::string &name,
                    const std::string &unit,
                    const Function    &parts)
    {
      fields.push_back(
        {name,
         unit,
         FieldLocation::material,
         FieldUse::on_request,
         {"x", "y", "z"},
         {},
         [parts](const std::string &material, const std::size_t component) {
           return parts(material)[component];
         }});
    }

    /** The first field, in the order of their declaration. */
    std::vector<Field>::const_iterator
    begin() const
    {
      return fields.begin();
    }

    /** One past the last field. */
    std::vector<Field>::const_iterator
    end() const
    {
      return fields.end();
    }

    /** Null if there is no field of this name at this place. */
    const Field *
    find(const std::string &name, const FieldLocation location) const
    {
      for (const Field &field : fields)
        if (field.name == name && field.location == location)
          return &field;
      return nullptr;
    }

  private:
    std::vector<Field> fields;
    const State       *the_state = nullptr;
    double             dt        = 0;
  };

  /** Which fields are written: by their names, `default` or `all`. */
  struct FieldSelection
  {
    /** As in the scene, without commas. */
    std::vector<std::string> words = {"default"};

    /** Whether a field is written. */
    bool
    includes(const Field &field) const
    {
      return std::any_of(words.begin(), words.end(), [&](const auto &word) {
        return word == field.name || word == "all" ||
               (word == "default" && field.use == FieldUse::by_default);
      });
    }
  };

  /** Declares displacement, velocity and speed of the nodes. */
  inline void
  declare_nodal_fields(FieldList &list)
  {
    const State *state     = list.state();
    const double time_step = list.time_step();
    list.add("displacement",
             "m",
             FieldLocation::node,
             [state](const std::size_t node) {
               return state->displacement[node].vector();
             });
    list.add("velocity",
             "m/s",
             FieldLocation::node,
             [state, time_step](const std::size_t node) {
               return velocity_at_step(*state, time_step, node);
             });
    list.add(
      "speed",
      "m/s",
      FieldLocation::node,
      [state, time_step](const std::size_t node) {
        return norm(velocity_at_step(*state, time_step, node));
      },
      FieldUse::on_request);
  }
} // namespace rift

#endif
