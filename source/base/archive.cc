#include <rift/base/archive.h>
#include <rift/base/check.h>
#include <rift/base/exceptions.h>

#include <stdexcept>

namespace rift
{
  namespace
  {
    ExactSum
    sum_of(const std::string &bytes)
    {
      rift_check(bytes.size() == sizeof(ExactSum::Digits));
      ExactSum::Digits digits;
      std::memcpy(&digits, bytes.data(), sizeof(digits));
      return ExactSum::from_digits(digits);
    }
  } // namespace

  void
  Archive::write(const std::string &name,
                 const Kind         kind,
                 const std::size_t  item_size,
                 const void        *items,
                 const std::size_t  n_items)
  {
    std::string bytes;
    if (n_items > 0)
      bytes.assign(static_cast<const char *>(items), item_size * n_items);
    if (!all.emplace(name, Entry{kind, item_size, std::move(bytes)}).second)
      throw std::logic_error("two entries of an archive are named " + name);
  }

  const Archive::Entry &
  Archive::find(const std::string &name,
                const Kind         kind,
                const std::size_t  item_size) const
  {
    const auto entry = all.find(name);
    if (entry == all.end() || entry->second.kind != kind ||
        entry->second.item_size != item_size)
      throw InputError("the checkpoint does not hold \"" + name +
                       "\" as this version of rift expects it. Continue with "
                       "the version that has written it.");
    return entry->second;
  }

  ExactSum
  Archive::read_sum(const std::string &name) const
  {
    return sum_of(find(name, Kind::sum, sizeof(ExactSum::Digits)).bytes);
  }

  void
  Archive::merge(const std::string &name, const Entry &entry)
  {
    const auto [known, is_new] = all.emplace(name, entry);
    if (is_new || entry.kind == Kind::value)
      return;
    rift_check(known->second.kind == entry.kind &&
               known->second.item_size == entry.item_size);
    std::string &bytes = known->second.bytes;
    if (entry.kind == Kind::list)
      bytes += entry.bytes;
    else
      {
        ExactSum total = sum_of(bytes);
        total.add(sum_of(entry.bytes));
        const ExactSum::Digits digits = total.digits();
        std::memcpy(bytes.data(), &digits, sizeof(digits));
      }
  }

  void
  Archive::clear_sums()
  {
    const ExactSum::Digits zero = ExactSum().digits();
    for (auto &[name, entry] : all)
      if (entry.kind == Kind::sum)
        std::memcpy(entry.bytes.data(), &zero, sizeof(zero));
  }
} // namespace rift
