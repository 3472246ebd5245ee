#include <rift/base/exceptions.h>
#include <rift/mesh/geo_script.h>

#include <cctype>
#include <fstream>
#include <map>
#include <sstream>

namespace rift
{
  namespace
  {
    // A word, a string (with its quotes) or one other character.
    using Token = std::string;

    bool
    in_word(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    }

    std::vector<Token>
    split_into_tokens(const std::string &text)
    {
      std::vector<Token> tokens;
      for (std::size_t i = 0; i < text.size();)
        {
          std::size_t end = i + 1;
          if (text.compare(i, 2, "//") == 0)
            end = text.find('\n', i);
          else if (text.compare(i, 2, "/*") == 0)
            end = text.find("*/", i + 2) == std::string::npos ?
                    std::string::npos :
                    text.find("*/", i + 2) + 2;
          else
            {
              if (text[i] == '"')
                end = text.find('"', i + 1) == std::string::npos ?
                        std::string::npos :
                        text.find('"', i + 1) + 1;
              else if (in_word(text[i]))
                while (end < text.size() && in_word(text[end]))
                  ++end;
              if (!std::isspace(static_cast<unsigned char>(text[i])))
                tokens.push_back(text.substr(i, end - i));
            }
          i = std::min(end, text.size());
        }
      return tokens;
    }

    // The tokens of a script with those of the files that it includes.
    std::vector<Token>
    read_tokens(const std::string &file, const unsigned int depth)
    {
      std::ifstream in(file);
      if (!in)
        throw InputError("The gmsh script '" + file +
                         "' cannot be opened. Check its path and that it may "
                         "be read.");
      if (depth > 20)
        throw InputError("The gmsh script '" + file +
                         "' includes itself. Remove its Include.");
      std::ostringstream text;
      text << in.rdbuf();

      std::vector<Token> result;
      bool               included = false;
      for (const Token &token : split_into_tokens(text.str()))
        {
          if (included && token.size() > 2 && token[0] == '"')
            {
              std::string name = token.substr(1, token.size() - 2);
              if (name[0] != '/')
                name = file.substr(0, file.find_last_of('/') + 1) + name;
              const auto inner = read_tokens(name, depth + 1);
              result.insert(result.end(), inner.begin(), inner.end());
            }
          else
            result.push_back(token);
          included = (token == "Include");
        }
      return result;
    }

    enum class FirstMention
    {
      use,
      assignment
    };

    std::map<std::string, FirstMention>
    find_first_mentions(const std::vector<Token> &tokens)
    {
      std::map<std::string, FirstMention> mentions;
      // Number of brackets open since DefineConstant.
      unsigned int depth    = 0;
      bool         defining = false;
      for (std::size_t i = 0; i < tokens.size(); ++i)
        {
          defining = defining || tokens[i] == "DefineConstant";
          if (defining && (tokens[i] == "[" || tokens[i] == "("))
            ++depth;
          else if (depth > 0 && (tokens[i] == "]" || tokens[i] == ")"))
            defining = (--depth > 0);

          const auto is = [&](const std::size_t k, const char *token) {
            return k < tokens.size() && tokens[k] == token;
          };
          const bool assigned = !defining && is(i + 1, "=") && !is(i + 2, "=");
          if (in_word(tokens[i][0]))
            mentions.emplace(tokens[i],
                             assigned ? FirstMention::assignment :
                                        FirstMention::use);
        }
      return mentions;
    }
  } // namespace

  void
  check_geo_parameters(const std::string              &file,
                       const std::vector<std::string> &names)
  {
    const auto mentions = find_first_mentions(read_tokens(file, 0));
    for (const std::string &name : names)
      {
        const auto mention = mentions.find(name);
        if (mention == mentions.end())
          throw InputError("The gmsh script '" + file +
                           "' does not use the parameter '" + name +
                           "'. Remove it from the scene, or write "
                           "DefineConstant[ " +
                           name + " = ... ]; into the script and use it.");
        if (mention->second == FirstMention::assignment)
          throw InputError("The gmsh script '" + file + "' sets '" + name +
                           "' itself, so that the value of the scene would be "
                           "lost. Write DefineConstant[ " +
                           name + " = ... ]; in place of " + name + " = ...;");
      }
  }
} // namespace rift
