#ifndef rift_module_module_with_work_h
#define rift_module_module_with_work_h

#include <rift/discretization/work.h>
#include <rift/module/module.h>

#include <string>

namespace rift
{
  /** A module that counts how much energy its forces put into the body or take
   * out of it, enters it into the ledger and saves it. */
  class ModuleWithWork : public Module
  {
  public:
    /**
     * @param topology must outlive this object.
     * @param name of the module, under which its work is saved.
     * @param energy name of the energy in the ledger to which it adds.
     */
    ModuleWithWork(const Topology    &topology,
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

    /** Energy up to t_n, J, with its sign in the ledger: that which loads have
     * put in, that which damping has taken out. As of the last call that
     * counts: count_work() or constrain(). */
    Work &
    work()
    {
      return work_done;
    }

  protected:
    /** What a module adds to. */
    Work work_done;

    /** Name of the module. */
    const std::string name;

  private:
    const std::string energy;
  };
} // namespace rift

#endif
