#include <rift/cohesive/face_strengths.h>
#include <rift/discretization/ghost_values.h>
#include <rift/material/elasticity.h>
#include <rift/material/strength_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  PlaneStrength::PlaneStrength(const MaterialParameters &material)
    : axes(material_axes(material.axis_1, material.axis_2))
    , tensile_strength(material.tensile_strength)
    , cohesion(material.cohesion)
    , fracture_energy_1(material.fracture_energy_1)
    , fracture_energy_2(material.fracture_energy_2)
    , tan_friction_angle(std::tan(material.friction_angle))
    , residual_friction(std::tan(
        material.residual_friction_angle.value_or(material.friction_angle)))
  {
  }

  FaceStrength
  PlaneStrength::across(const Vector3<double> &normal) const
  {
    const Vector3<double> n = axes * normal;
    return {tensile_strength.at(n),
            cohesion.at(n),
            tan_friction_angle,
            residual_friction,
            fracture_energy_1.at(n),
            fracture_energy_2.at(n)};
  }

  FaceStrengths::FaceStrengths(const Topology                        &topology,
                               const ReferenceCellData               &reference,
                               const std::vector<MaterialParameters> &materials,
                               const CohesiveParameters &parameters)
    : topology(topology)
    , reference(reference)
    , materials(materials)
  {
    constexpr Vector3<double> any = {{1, 0, 0}};
    for (const MaterialParameters &a : materials)
      for (const MaterialParameters &b : materials)
        pairs.push_back(
          weaker_of(strength_across(a, any), strength_across(b, any)));
    if (any_scatters(materials))
      scatter(parameters.seed);
  }

  void
  FaceStrengths::scatter(const unsigned int seed)
  {
    factors.assign(topology.faces.size(), 1.);
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        // The side of more scatter (smaller modulus) decides.
        double modulus = 0;
        for (const CellIndex cell : topology.faces[face].cells)
          {
            const double m = materials[topology.material(cell)].weibull_modulus;
            if (m > 0 && (modulus == 0 || m < modulus))
              modulus = m;
          }
        if (modulus > 0)
          factors[face] = random_factor(face, modulus, seed);
      }
  }

  double
  FaceStrengths::random_factor(const FaceIndex    face,
                               const double       modulus,
                               const unsigned int seed)
  {
    const Face         &f = topology.faces[face];
    const std::uint64_t name =
      4 * std::uint64_t{topology.cell_global_indices[f.cells[0]]} +
      f.local_faces[0];
    const std::uint64_t bits = scramble(scramble(seed) ^ name);
    return weibull_factor(unit_number(bits), modulus);
  }

  bool
  FaceStrengths::is_breakable(const FaceIndex face) const
  {
    const Face &f = topology.faces[face];
    return materials[topology.material(f.cells[0])].breakable &&
           materials[topology.material(f.cells[1])].breakable;
  }

  FaceStrength
  FaceStrengths::weaker_side(const FaceIndex face) const
  {
    const Face         &f = topology.faces[face];
    const std::uint16_t a = topology.material(f.cells[0]);
    const std::uint16_t b = topology.material(f.cells[1]);
    if (!materials[a].has_directional_strength() &&
        !materials[b].has_directional_strength())
      return pairs[a * materials.size() + b];
    const Vector3<double> area =
      reference_area_vector(reference, f.cells[0], f.local_faces[0]);
    const Vector3<double> normal = (1 / norm(area)) * area;
    return weaker_of(strength_across(materials[a], normal),
                     strength_across(materials[b], normal));
  }

  FaceStrength
  FaceStrengths::strength(const FaceIndex face) const
  {
    const FaceStrength result = weaker_side(face);
    return factors.empty() ? result : result.scattered(factors[face]);
  }

  StressBounds
  FaceStrengths::stress_bounds(const Communicator &communicator) const
  {
    constexpr double margin = .9;

    // One friction angle for all materials: with different ones on its two
    // sides, a face could be at its strength and neither cell at its bound.
    // The least friction allows the most shear in compression.
    constexpr double largest = std::numeric_limits<double>::max();
    double           tan     = largest;
    for (const MaterialParameters &material : materials)
      if (material.breakable)
        tan = std::min(tan, std::tan(material.friction_angle));

    const std::size_t   n_materials = materials.size();
    std::vector<double> tensile_strengths(n_materials, largest);
    std::vector<double> cohesions(n_materials, largest);
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (is_breakable(face))
        {
          const FaceStrength s = weaker_side(face);
          for (const CellIndex cell : topology.faces[face].cells)
            {
              const auto m = topology.material(cell);
              tensile_strengths[m] =
                std::min(tensile_strengths[m], s.tensile_strength);
              cohesions[m] = std::min(cohesions[m], s.cohesion);
            }
        }

    // Of the whole body: which cells are looked at must not depend on the rank.
    StressBounds bounds{std::vector<std::optional<StressBound>>(n_materials),
                        cell_factors(communicator)};
    for (std::size_t m = 0; m < n_materials; ++m)
      {
        const double tensile_strength =
          -communicator.max(-tensile_strengths[m]);
        const double cohesion = -communicator.max(-cohesions[m]);
        if (tensile_strength < largest)
          bounds.materials[m] =
            StressBound{margin * tensile_strength, margin * cohesion, tan};
      }
    return bounds;
  }

  std::vector<Simd>
  FaceStrengths::cell_factors(const Communicator &communicator) const
  {
    // A rank may have no faces, but must answer the others.
    if (!any_scatters(materials))
      return {};
    std::vector<double> smallest(topology.n_cell_slots(),
                                 std::numeric_limits<double>::infinity());
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (is_breakable(face))
        for (const CellIndex cell : topology.faces[face].cells)
          smallest[cell] = std::min(smallest[cell], factors[face]);
    // Not all faces of a ghost are here.
    copy_to_ghosts(communicator, topology, smallest);
    return by_batches(smallest);
  }
} // namespace rift
