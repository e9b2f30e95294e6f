/// Reading and writing urbiscript literals.
#ifndef URBI_DETAIL_LITERAL_HH
#define URBI_DETAIL_LITERAL_HH

#include <cctype>
#include <charconv>
#include <cstring>
#include <limits>
#include <string>

#include <urbi/uvalue.hh>

namespace urbi
{
  namespace detail
  {
    /// What operator[] does, without the variable of the standard library that this refers to: the
    /// compiler may make it one of the whole process, and a module with such can not be unloaded.
    UValue& entry(UDictionary& dictionary, const std::string& name);

    /// A number as urbiscript writes it: without decimals where it has none.
    std::string number_text(ufloat number);

    /// A string in quotes, with what has to be escaped.
    std::string quoted(const std::string& text);

    /// Reads a text that is one literal and nothing else.
    bool read_literal(const std::string& text, UValue& out);
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/literal.hh>
#endif

#endif
