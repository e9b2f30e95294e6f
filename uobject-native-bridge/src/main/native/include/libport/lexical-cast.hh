/// Values as texts, and texts as values.
#ifndef LIBPORT_LEXICAL_CAST_HH
#define LIBPORT_LEXICAL_CAST_HH

#include <sstream>
#include <stdexcept>
#include <string>

namespace libport
{
  /// What a text says in another type. \throw std::runtime_error if it says nothing of that type
  template <typename T>
  T lexical_cast(const std::string& text)
  {
    std::istringstream in(text);
    T value;
    if (!(in >> value) || !(in >> std::ws).eof())
      throw std::runtime_error("bad lexical cast: " + text);
    return value;
  }

  template <>
  inline std::string lexical_cast<std::string>(const std::string& text)
  {
    return text;
  }
}

/// What values look like when they are written to a stream, one after the other.
template <typename... T>
std::string string_cast(const T&... values)
{
  std::ostringstream out;
  int order[] = {0, (out << values, 0)...};
  static_cast<void>(order);
  return out.str();
}

#endif
