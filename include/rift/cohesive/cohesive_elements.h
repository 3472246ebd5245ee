#ifndef rift_cohesive_cohesive_elements_h
#define rift_cohesive_cohesive_elements_h

#include <rift/base/exact_sum.h>
#include <rift/base/plain_bytes.h>
#include <rift/cohesive/cohesive_faces.h>
#include <rift/cohesive/cohesive_parameters.h>
#include <rift/cohesive/face_strengths.h>
#include <rift/cohesive/open_faces.h>
#include <rift/cohesive/penalty_stiffness.h>
#include <rift/discretization/ghost_exchange.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rift
{
  /** Energies of the cohesive elements that this rank owns, J. */
  struct CohesiveEnergy
  {
    /** Elastic, less what the faces were given when they began to open; what
     * fracture uses up of that counts until a face has failed. */
    ExactSum recoverable;

    /** Used up until now, by fracture and by friction. */
    ExactSum fracture;
    ExactSum friction;
  };

  /** What every cohesive element remembers, for a checkpoint. */
  struct CohesiveFaceRecord
  {
    /** The face, by a name that all ranks share. */
    FaceName face;

    /** CohesiveFaceInfo; s. */
    double start_time, failure_time;

    /** Energies used up, and given at the start, J. */
    double fracture, friction, given_cohesive, given_frictional;
  };

  template <>
  struct HasPlainBytes<CohesiveFaceRecord> : std::true_type
  {
    static_assert(sizeof(CohesiveFaceRecord) ==
                  sizeof(FaceName) + 6 * sizeof(double));
  };

  /** Cohesive elements in a checkpoint. */
  struct CohesiveRecords
  {
    /** One record for each cohesive element. */
    std::vector<CohesiveFaceRecord> faces;

    /** What their Gauss points remember by the name of each field of their law:
     * the numbers of all points of the first face, then of the second. */
    std::map<std::string, std::vector<double>> points;
  };

  /**
   * What the cohesive elements at some faces remember, and the tractions that
   * their law makes of that: see CohesiveElementsOf. Functions are called once
   * per step for all faces, not face by face.
   */
  class CohesiveElements
  {
  public:
    virtual ~CohesiveElements() = default;

    /** Starts the elements of faces that have been added to CohesiveFaces. */
    virtual void
    take_in_new_faces() = 0;

    /**
     * Adds the forces of all faces, after updating what they remember and their
     * states.
     */
    virtual void
    add_to(State &state, const Activity &activity) = 0;

    /**
     * Gives the points of faces the traction that makes the forces of their
     * corners.
     *
     * @param corners those of a face one after the other.
     */
    virtual void
    hold(const State &state, const std::vector<OpeningCorner> &corners) = 0;

    /** @param state as at the last add_to(). */
    virtual CohesiveEnergy
    energy(const State &state) const = 0;

    /** Number of faces of this rank that have opened though the mesh is too
     * coarse for their fracture energy. */
    virtual std::size_t
    count_unresolved() const = 0;

    /** For all faces, in their order. */
    virtual std::vector<FaceMeans>
    means(const State &state) const = 0;

    /** Bytes that constants and memory take, besides the faces themselves. */
    virtual std::size_t
    n_bytes() const = 0;

    /** The faces that this rank owns and that have opened. */
    virtual CohesiveRecords
    records() const = 0;

    /**
     * Has faces remember what the records say.
     *
     * @param indices in CohesiveFaces of the faces of the records;
     *   invalid_index for those that this rank does not need.
     */
    virtual void
    restore(const CohesiveRecords          &records,
            const std::vector<std::size_t> &indices) = 0;
  };

  /** Elements of the law that the parameters choose. All references must
   * outlive them. */
  std::unique_ptr<CohesiveElements>
  make_cohesive_elements(const CohesiveParameters &parameters,
                         CohesiveFaces            &faces,
                         const Topology           &topology,
                         const FaceStrengths      &strengths,
                         PenaltyStiffness          stiffness_of);
} // namespace rift

#endif
