#ifndef rift_base_parameter_comparison_h
#define rift_base_parameter_comparison_h

#include <string>
#include <vector>

namespace rift
{
  /**
   * How the parameters of a scene differ from those of the checkpoint from
   * which it is to go on: a sentence for each entry, such as "Material rock /
   * Density is 2641 here and 2700 in the checkpoint", and one for a subsection
   * that only one of them has. The order of entries and subsections does not
   * count.
   *
   * @param here, in_checkpoint texts of a .prm that used_parameters() has
   *   written: one line for each entry, without comments.
   * @param may_differ entries that are passed over, as `Time/End time`, or
   *   whole subsections, as `Output`.
   */
  std::vector<std::string>
  parameter_differences(const std::string              &here,
                        const std::string              &in_checkpoint,
                        const std::vector<std::string> &may_differ);
} // namespace rift

#endif
