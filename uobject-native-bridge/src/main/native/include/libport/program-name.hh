/// The name of the program, and its arguments.
#ifndef LIBPORT_PROGRAM_NAME_HH
#define LIBPORT_PROGRAM_NAME_HH

#include <string>
#include <vector>

#include <libport/compiler.hh>
#include <libport/fwd.hh>

namespace libport
{
  namespace detail
  {
    struct Program
    {
      std::string name;
      cli_args_type arguments;
    };

    LIBPORT_LOCAL inline Program& program()
    {
      static Program own;
      return own;
    }
  }

  /// Remembers what main was given.
  inline void program_initialize(const cli_args_type& words)
  {
    detail::program().name = words.empty() ? std::string() : words[0];
    detail::program().arguments.assign(words.empty() ? words.end() : words.begin() + 1, words.end());
  }

  inline void program_initialize(int argc, const char* const* argv)
  {
    program_initialize(cli_args_type(argv, argv + argc));
  }

  inline const std::string& program_name()
  {
    return detail::program().name;
  }

  /// The arguments, without the name.
  inline const cli_args_type& program_arguments()
  {
    return detail::program().arguments;
  }
}

#endif
