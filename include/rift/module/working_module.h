#ifndef rift_module_working_module_h
#define rift_module_working_module_h

#include <rift/discretization/work.h>
#include <rift/module/module.h>

#include <string>

namespace rift
{
  /** A module that adds up the work of its forces, enters it into the ledger
   * and saves it. */
  class WorkingModule : public Module
  {
  public:
    /**
     * @param topology must outlive this object.
     * @param name of the module, under which its work is saved.
     * @param energy to which its work counts.
     */
    WorkingModule(const Topology    &topology,
                  const std::string &name,
                  const std::string &energy)
      : work_done(topology)
      , name(name)
      , energy(energy)
    {
    }

    void
    account(const Discretization &, EnergyTable &energies) const override
    {
      energies[energy].add(work_done.sum());
    }

    void
    save(const Discretization &, Archive &archive) const override
    {
      work_done.save(name, archive);
    }

    void
    load(const Discretization &, const Archive &archive) override
    {
      work_done.load(name, archive);
    }

    /** Work up to t_n, J, as of the last count_work(). */
    Work &
    work()
    {
      return work_done;
    }

  protected:
    /** What a module adds to in count_work(). */
    Work work_done;

    /** Name of the module. */
    const std::string name;

  private:
    const std::string energy;
  };
} // namespace rift

#endif
