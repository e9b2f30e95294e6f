/// Texts as they are written in programs.
#ifndef LIBPORT_ESCAPE_HH
#define LIBPORT_ESCAPE_HH

#include <cstdio>
#include <string>

namespace libport
{
  /// With backslashes before what cannot stand between quotes.
  inline std::string escape(const std::string& text, char quote = 0)
  {
    std::string out;
    for (char c : text)
      switch (c)
      {
      case '\\': out += "\\\\"; break;
      case '\n': out += "\\n"; break;
      case '\t': out += "\\t"; break;
      case '\r': out += "\\r"; break;
      case '"': out += "\\\""; break;
      default:
        if (quote && c == quote)
          (out += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
        {
          char code[5];
          std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
          out += code;
        }
        else
          out += c;
      }
    return out;
  }
}

#endif
