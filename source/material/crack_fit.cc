#include <rift/base/exceptions.h>
#include <rift/material/crack_fit.h>

#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>

namespace rift
{
  namespace
  {
    struct Problem
    {
      StiffnessMatrix         intact;
      std::vector<CrackGroup> groups;
      CrackScheme             scheme;
      const std::function<std::vector<double>(const StiffnessMatrix &)>
        &residuals;

      /** Groups whose densities are the squares of the unknowns. */
      std::vector<CrackGroup>
      groups_of(const gsl_vector *roots) const
      {
        std::vector<CrackGroup> result = groups;
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i].density = std::pow(gsl_vector_get(roots, i), 2);
        return result;
      }
    };

    int
    evaluate(const gsl_vector *roots, void *data, gsl_vector *result)
    {
      const Problem &problem   = *static_cast<const Problem *>(data);
      const auto     stiffness = stiffness_with_cracks(problem.intact,
                                                   problem.groups_of(roots),
                                                   problem.scheme);
      if (!stiffness)
        return GSL_EDOM;
      const std::vector<double> residuals = problem.residuals(*stiffness);
      for (std::size_t i = 0; i < residuals.size(); ++i)
        gsl_vector_set(result, i, residuals[i]);
      return GSL_SUCCESS;
    }
  } // namespace

  double
  CrackFit::mean_residual() const
  {
    double sum = 0;
    for (const double r : residuals)
      sum += r * r;
    return std::sqrt(sum / residuals.size());
  }

  CrackFit
  fit_cracks(const StiffnessMatrix         &intact,
             const std::vector<CrackGroup> &start,
             const CrackScheme              scheme,
             const std::function<std::vector<double>(const StiffnessMatrix &)>
               &residuals)
  {
    constexpr std::size_t largest_number_of_iterations = 200;
    constexpr double      tolerance                    = 1e-10;

    Problem           problem{intact, start, scheme, residuals};
    const std::size_t n_residuals = residuals(intact).size();
    if (n_residuals < start.size())
      throw InputError("a fit of " + std::to_string(start.size()) +
                       " crack densities needs as many measured values; there "
                       "are " +
                       std::to_string(n_residuals) + ".");
    gsl_multifit_nlinear_fdf function{};
    function.f      = evaluate;
    function.n      = n_residuals;
    function.p      = start.size();
    function.params = &problem;

    const auto options = gsl_multifit_nlinear_default_parameters();
    const std::unique_ptr<gsl_multifit_nlinear_workspace,
                          decltype(&gsl_multifit_nlinear_free)>
      workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust,
                                           &options,
                                           function.n,
                                           function.p),
                gsl_multifit_nlinear_free);
    std::vector<double> roots;
    for (const CrackGroup &group : start)
      roots.push_back(std::sqrt(group.density));
    gsl_vector_view view   = gsl_vector_view_array(roots.data(), roots.size());
    int             reason = 0;
    int             status =
      gsl_multifit_nlinear_init(&view.vector, &function, workspace.get());
    if (status == GSL_SUCCESS)
      status = gsl_multifit_nlinear_driver(largest_number_of_iterations,
                                           tolerance,
                                           tolerance,
                                           0,
                                           nullptr,
                                           nullptr,
                                           &reason,
                                           workspace.get());
    // No progress is what the best there is looks like.
    if (status != GSL_SUCCESS && status != GSL_ENOPROG)
      throw InputError(std::string("the fit of crack densities has not come to "
                                   "an end: ") +
                       gsl_strerror(status) +
                       ". Start it with other densities.");
    CrackFit fit;
    fit.groups =
      problem.groups_of(gsl_multifit_nlinear_position(workspace.get()));
    const gsl_vector *left = gsl_multifit_nlinear_residual(workspace.get());
    for (std::size_t i = 0; i < left->size; ++i)
      fit.residuals.push_back(gsl_vector_get(left, i));
    return fit;
  }
} // namespace rift
