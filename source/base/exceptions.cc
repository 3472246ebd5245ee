#include <rift/base/exceptions.h>

#include <new>
#include <optional>

namespace rift
{
  Error
  to_error(const std::exception &exception)
  {
    if (const auto *error = dynamic_cast<const Error *>(&exception))
      return *error;
    if (dynamic_cast<const std::bad_alloc *>(&exception) != nullptr)
      return RunError("the memory of this machine is too small for this scene. "
                      "Use larger elements.");
    return RunError(std::string("rift has failed in a way that it does not "
                                "foresee. Please report this: ") +
                    exception.what());
  }

  void
  call_all(const std::vector<std::function<void()>> &functions)
  {
    std::optional<Error> first;
    for (const auto &function : functions)
      try
        {
          function();
        }
      catch (const std::exception &exception)
        {
          if (!first)
            first.emplace(to_error(exception));
        }
    if (first)
      throw *first;
  }
} // namespace rift
