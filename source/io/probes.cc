#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/io/probes.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Shape functions of the corners of a cell at a point of the undeformed
     * body. */
    std::array<double, n_corners>
    shape_functions(const Topology          &topology,
                    const ReferenceCellData &reference,
                    const State             &state,
                    const CellIndex          cell,
                    const Vector3<double>   &point)
    {
      const ReferenceBatch &batch = reference[cell / batch_size];
      const Vector3<double> from_corner =
        point - state.reference[topology.node(cell, 0)].vector();
      std::array<double, n_corners> shape = {{1, 0, 0, 0}};
      for (unsigned int c = 1; c < n_corners; ++c)
        {
          shape[c] = dot(batch.gradient(c, cell % batch_size), from_corner);
          shape[0] -= shape[c];
        }
      return shape;
    }
  } // namespace

  std::vector<Vector3<double>>
  velocity_at_step(const State &state, const double time_step)
  {
    std::vector<Vector3<double>> velocity(state.n_nodes());
    for (std::size_t i = 0; i < velocity.size(); ++i)
      velocity[i] = velocity_at_step(state, time_step, i);
    return velocity;
  }

  Probe::Probe(const Topology          &topology,
               const ReferenceCellData &reference,
               const State             &state,
               const ProbeParameters   &the_parameters,
               const Surface           &surface,
               const Communicator      &communicator)
    : parameters(the_parameters)
  {
    if (parameters.field.location == FieldLocation::material)
      return;
    if (parameters.boundary.empty())
      find_point(topology, reference, state, communicator);
    else
      weigh_surface(topology, reference, surface, communicator);
  }

  void
  Probe::find_point(const Topology          &topology,
                    const ReferenceCellData &reference,
                    const State             &state,
                    const Communicator      &communicator)
  {
    // The cell whose smallest shape function at the point is largest: inside
    // of a cell all are positive, on a face the first cell is as good as any.
    constexpr double tolerance = 1e-9;
    double           best      = -tolerance;
    Sample           found{invalid_index, {}};
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        if (!topology.owns_cell(cell))
          continue;
        const auto shape =
          shape_functions(topology, reference, state, cell, parameters.point);
        const double smallest = *std::min_element(shape.begin(), shape.end());
        if (smallest > best)
          {
            best  = smallest;
            found = {cell, shape};
          }
      }

    // Among the best of each rank that of the smallest global index.
    constexpr double none = -1. * invalid_index;
    const bool       is_best =
      communicator.max(best) == best && found.cell != invalid_index;
    const double index =
      is_best ? -1. * topology.cell_global_indices[found.cell] : none;
    const double first = communicator.max(index);
    if (first == none)
      throw InputError("the point (" + to_text(parameters.point[0]) + ", " +
                       to_text(parameters.point[1]) + ", " +
                       to_text(parameters.point[2]) +
                       ") m of subsection \"Probe " + parameters.name +
                       "\" lies in no cell of the mesh. Move it into the body; "
                       "coordinates are in metres.");
    if (is_best && index == first)
      samples.push_back(found);
  }

  void
  Probe::weigh_surface(const Topology          &topology,
                       const ReferenceCellData &reference,
                       const Surface           &surface,
                       const Communicator      &communicator)
  {
    ExactSum total;
    for (const CellFace &face : surface)
      {
        if (!topology.owns_cell(face.cell))
          continue;
        const double area =
          norm(reference_area_vector(reference, face.cell, face.local_face));
        Sample sample{face.cell, {}};
        for (const unsigned int c : face_corners[face.local_face])
          sample.weights[c] = area / 3;
        samples.push_back(sample);
        total.add(area);
      }
    ExactSum::sum_over_ranks({&total}, communicator);
    const double total_area = total.value();
    for (Sample &sample : samples)
      for (double &weight : sample.weights)
        weight /= total_area;
  }

  ExactSum
  Probe::sum(const Topology &topology, const FieldList &fields) const
  {
    const auto &[name, unit, location, component] = parameters.field;
    const Field *field                            = fields.find(name, location);
    if (field == nullptr)
      throw InputError("subsection \"Probe " + parameters.name +
                       "\": nothing in this scene has the field \"" + name +
                       "\".");
    if (location == FieldLocation::material)
      return field->sum(parameters.material, component);
    ExactSum              result;
    std::array<double, 6> values;
    for (const Sample &sample : samples)
      if (location == FieldLocation::cell)
        {
          double weight = 0;
          for (const double w : sample.weights)
            weight += w;
          field->values(sample.cell, values.data());
          result.add(weight * values[component]);
        }
      else
        for (unsigned int c = 0; c < n_corners; ++c)
          {
            field->values(topology.node(sample.cell, c), values.data());
            result.add(sample.weights[c] * values[component]);
          }
    return result;
  }

  std::vector<double>
  probe_values(const std::vector<Probe> &probes,
               const Topology           &topology,
               const FieldList          &fields,
               const Communicator       &communicator)
  {
    std::vector<ExactSum> sums;
    for (const Probe &probe : probes)
      sums.push_back(probe.sum(topology, fields));
    std::vector<ExactSum *> pointers;
    for (ExactSum &sum : sums)
      pointers.push_back(&sum);
    ExactSum::sum_over_ranks(pointers, communicator);
    std::vector<double> values;
    for (const ExactSum &sum : sums)
      values.push_back(sum.value());
    return values;
  }
} // namespace rift
