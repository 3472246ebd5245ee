#ifndef rift_cohesive_cohesive_elements_of_h
#define rift_cohesive_cohesive_elements_of_h

#include <rift/cohesive/cohesive_elements.h>
#include <rift/cohesive/face_kinematics.h>
#include <rift/cohesive/laws/fields.h>
#include <rift/cohesive/laws/law_values.h>

namespace rift
{
  /**
   * Cohesive elements of one law; doc/adding-a-law.md has what a law consists
   * of. Elements stand in batches, like their faces. In the extrinsic model a
   * batch has a memory from the start, in the intrinsic one from when the first
   * of its points leaves the envelope.
   */
  template <typename Law>
  class CohesiveElementsOf final : public CohesiveElements
  {
  public:
    /** What the law remembers at a point, and what the points of a face
     * share. */
    using Point     = typename Law::template Point<double>;
    using Constants = typename Law::template Constants<double>;

    static_assert(has_all_fields<Point>() && has_all_fields<Constants>(),
                  "what fields() does not list is lost in checkpoints");

    /** The arguments but the last must outlive this object. */
    CohesiveElementsOf(CohesiveFaces       &faces,
                       const Topology      &topology,
                       const FaceStrengths &strengths,
                       PenaltyStiffness     stiffness_of);

    void
    take_in_new_faces() override;

    void
    add_to(State &state, const Activity &activity) override;

    void
    hold(const State                      &state,
         const std::vector<OpeningCorner> &corners) override;

    CohesiveEnergy
    energy(const State &state) const override;

    std::size_t
    count_unresolved() const override;

    std::vector<FaceMeans>
    means(const State &state) const override;

    std::size_t
    n_bytes() const override
    {
      return all_constants.size() *
               (sizeof(ConstantsOfBatch) + sizeof(std::uint32_t)) +
             memories.size() * sizeof(Memory);
    }

    CohesiveRecords
    records() const override;

    void
    restore(const CohesiveRecords          &records,
            const std::vector<std::size_t> &indices) override;

    // What tests look at.

    /** The constants of the law for a face, by index in CohesiveFaces. */
    Constants
    constants(const std::size_t face) const
    {
      return get_lane<Constants>(all_constants[face / batch_size],
                                 face % batch_size);
    }

    /** A face that has a memory. */
    Point
    point(const std::size_t face, const unsigned int q) const
    {
      return get_lane<Point>(
        memories[memory_of_batch[face / batch_size]].points[q],
        face % batch_size);
    }

    /** Sets what Gauss point q of a face remembers. */
    void
    set_point(const std::size_t face, const unsigned int q, const Point &value)
    {
      set_lane(memories[memory_of_batch[face / batch_size]].points[q],
               face % batch_size,
               value);
    }

  private:
    using PointsOfBatch    = typename Law::template Point<Simd>;
    using ConstantsOfBatch = typename Law::template Constants<Simd>;

    static constexpr bool is_intrinsic = Law::model == CohesiveModel::intrinsic;

    /** What eight elements remember of what they have gone through. */
    struct Memory
    {
      std::array<PointsOfBatch, n_face_points> points;

      /** Energies of a face that fracture and friction have used up, J. */
      Simd fracture, friction;

      /** The InitialEnergy that a face was given when its nodes parted, J. */
      Simd given_cohesive, given_frictional;
    };

    /** Null if the batch has none. */
    const Memory *
    memory_of(const std::size_t batch) const
    {
      const std::uint32_t memory = memory_of_batch[batch];
      return memory == invalid_index ? nullptr : &memories[memory];
    }

    Memory *
    memory_of(const std::size_t batch)
    {
      const std::uint32_t memory = memory_of_batch[batch];
      return memory == invalid_index ? nullptr : &memories[memory];
    }

    /** Strength of a cohesive element. */
    FaceStrength
    strength_of(const std::size_t index) const
    {
      return strengths.strength(faces.infos[index].face);
    }

    /** Gives a batch a memory in which nothing has happened yet. */
    Memory &
    make_memory(std::size_t batch);

    /** Makes the points of a face those of an intact one. */
    void
    start_points(Memory &memory, std::size_t index) const;

    /** Tractions of a batch without memory.
     * @param[out] yields whether any point leaves the envelope. */
    FaceTractions
    intact_tractions(std::size_t           batch,
                     const FaceKinematics &kinematics,
                     bool                 &yields) const;

    /** Updates the memory of a batch and the states of its faces, and returns
     * its tractions.
     * @param[in,out] area that acts; zero where a face lets go. */
    FaceTractions
    update(std::size_t           batch,
           Memory               &memory,
           const FaceKinematics &kinematics,
           const State          &state,
           Simd                 &area);

    /** Notes which faces have damage and which have failed. */
    void
    note_states(std::size_t     batch,
                const SimdMask &has_opened,
                const SimdMask &has_failed,
                double          time);

    /** Lets go of faces: what is left of their elastic energy counts as used
     * up. */
    void
    release(std::size_t     batch,
            Memory         &memory,
            const SimdMask &lanes,
            double          time,
            Simd           &area);

    /** Gives the points of one face the traction that makes these forces. */
    void
    hold_face(const State         &state,
              const OpeningCorner *first,
              const OpeningCorner *last);

    /** Elastic energies of the faces of a batch, J. */
    Simd
    elastic_energy(const State &state, std::size_t batch) const;

    CohesiveFaces         &faces;
    const Topology        &topology;
    const FaceStrengths   &strengths;
    const PenaltyStiffness stiffness_of;
    const Law              law{};
    const FaceQuadrature   quadrature;

    /** Number of faces that have been taken in. */
    std::size_t n_known_faces = 0;

    /** Of each batch: constants, and the index of its memory, if it has one. */
    std::vector<ConstantsOfBatch> all_constants;
    std::vector<std::uint32_t>    memory_of_batch;
    std::vector<Memory>           memories;
  };
} // namespace rift

#include <rift/cohesive/cohesive_elements_of.templates.h>
#include <rift/cohesive/cohesive_records_of.templates.h>

#endif
