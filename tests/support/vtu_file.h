#ifndef rift_tests_support_vtu_file_h
#define rift_tests_support_vtu_file_h

#include "../temporary_directory.h"
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace rift::test
{
  /** The value of an attribute of an XML element. */
  inline std::string
  attribute(const std::string &element, const std::string &name)
  {
    const auto start = element.find(" " + name + "=\"");
    if (start == std::string::npos)
      return "(none)";
    const auto begin = start + name.size() + 3;
    return element.substr(begin, element.find('"', begin) - begin);
  }

  /** A reader that shares no code with the writer. */
  class VtuFile
  {
  public:
    explicit VtuFile(const std::string &path)
      : content(read_file(path))
    {
      const auto begin = content.find("encoding=\"raw\">\n_") + 17;
      data             = content.substr(begin);
      content.resize(begin);
    }

    /** The same file with nothing but one of its pieces. */
    VtuFile
    piece(const unsigned int number) const
    {
      std::size_t begin = 0;
      for (unsigned int i = 0; i <= number; ++i)
        begin = content.find("<Piece", begin + 1);
      VtuFile result = *this;
      result.content =
        content.substr(begin, content.find("</Piece>", begin) - begin);
      return result;
    }

    unsigned int
    n_pieces() const
    {
      unsigned int n = 0;
      for (auto at = content.find("<Piece"); at != std::string::npos;
           at      = content.find("<Piece", at + 1))
        ++n;
      return n;
    }

    /** The element that begins with `text`. */
    std::string
    element(const std::string &text) const
    {
      const auto begin = content.find(text);
      if (begin == std::string::npos)
        return "(none)";
      return content.substr(begin, content.find('>', begin) - begin + 1);
    }

    std::string
    array_element(const std::string &name) const
    {
      const auto at = content.find(" Name=\"" + name + "\"");
      if (at == std::string::npos)
        return "(none)";
      return element(
        content.substr(content.rfind('<', at),
                       content.find('>', at) - content.rfind('<', at) + 1));
    }

    template <typename Number>
    std::vector<Number>
    array(const std::string &name) const
    {
      const char *header =
        &data[std::stoul(attribute(array_element(name), "offset"))];
      const auto number = [&](const std::size_t i) {
        std::uint64_t value;
        std::memcpy(&value, header + 8 * i, 8);
        return value;
      };
      const std::uint64_t n_blocks = number(0), block = number(1);
      const char         *compressed = header + 8 * (3 + n_blocks);
      std::string         bytes;
      for (std::uint64_t i = 0; i < n_blocks; ++i)
        {
          const bool partial  = i + 1 == n_blocks && number(2) > 0;
          uLongf     size     = partial ? number(2) : block;
          const auto expected = size;
          bytes.resize(bytes.size() + size);
          EXPECT_EQ(
            uncompress(reinterpret_cast<Bytef *>(&bytes[bytes.size() - size]),
                       &size,
                       reinterpret_cast<const Bytef *>(compressed),
                       number(3 + i)),
            Z_OK);
          EXPECT_EQ(size, expected);
          compressed += number(3 + i);
        }
      std::vector<Number> result(bytes.size() / sizeof(Number));
      if (!result.empty())
        std::memcpy(result.data(), bytes.data(), bytes.size());
      return result;
    }

    /** What comes before the data. */
    std::string content;

  private:
    std::string data;
  };
} // namespace rift::test

#endif
