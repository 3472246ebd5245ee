#ifndef rift_discretization_reference_cell_data_h
#define rift_discretization_reference_cell_data_h

#include <rift/base/simd.h>
#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /**
   * What the linear finite element knows of eight cells in the undeformed
   * body. Padding has zeros everywhere.
   */
  struct ReferenceBatch
  {
    /**
     * gradients[a][d]: derivative by X_d of the shape function of corner
     * a + 1, 1/m. Corner 0 has minus the sum of the three.
     */
    Matrix3<Simd> gradients;

    /** Volume, m^3. */
    Simd volume;

    /** Gradient of the shape function of any corner of one cell, 1/m. */
    Vector3<double>
    gradient(const unsigned int corner, const unsigned int lane) const
    {
      Vector3<double> result = {{0, 0, 0}};
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = corner > 0 ?
                      gradients[corner - 1][d][lane] :
                      -(gradients[0][d][lane] + gradients[1][d][lane] +
                        gradients[2][d][lane]);
      return result;
    }
  };

  /** Gradients and volumes of all cells, by batch. */
  using ReferenceCellData = std::vector<ReferenceBatch>;

  /**
   * Outward area vector (normal times area) of the face opposite to a corner
   * in the undeformed body, m^2: -3 V grad N of that corner.
   */
  inline Vector3<double>
  reference_area_vector(const ReferenceCellData &data,
                        const CellIndex          cell,
                        const unsigned int       local_face)
  {
    const ReferenceBatch &batch = data[cell / batch_size];
    const unsigned int    lane  = cell % batch_size;
    return (-3. * batch.volume[lane]) * batch.gradient(local_face, lane);
  }

  /** Area of an interior face in the undeformed body, m^2. */
  inline double
  reference_area(const Topology          &topology,
                 const ReferenceCellData &data,
                 const FaceIndex          face)
  {
    const Face &f = topology.faces[face];
    return norm(reference_area_vector(data, f.cells[0], f.local_faces[0]));
  }

  /**
   * Mass that the cells around a node lump to it, kg: in ascending order of
   * the cells, so that it is the same whenever and wherever it is summed.
   *
   * @param densities kg/m^3 of each material.
   */
  double
  lumped_mass(const Topology            &topology,
              const ReferenceCellData   &data,
              const std::vector<double> &densities,
              NodeIndex                  node);
} // namespace rift

#endif
