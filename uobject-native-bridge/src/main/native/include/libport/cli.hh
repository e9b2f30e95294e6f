/// What is wrong with the arguments of a program.
#ifndef LIBPORT_CLI_HH
#define LIBPORT_CLI_HH

#include <iostream>
#include <sstream>
#include <string>

#include <libport/lexical-cast.hh>
#include <libport/program-name.hh>
#include <libport/sysexits.hh>

namespace libport
{
  /// Ends the program: it was called in a wrong way.
  [[noreturn]] inline void usage_error(const std::string& problem)
  {
    std::cerr << program_name() << ": " << problem << "\nTry `" << program_name()
              << " --help' for more information." << std::endl;
    std::exit(EX_USAGE);
  }

  [[noreturn]] inline void usage_error(const std::string& option, const std::string& problem)
  {
    usage_error(option + ": " + problem);
  }

  [[noreturn]] inline void invalid_option(const std::string& option)
  {
    usage_error("invalid option: " + option);
  }

  [[noreturn]] inline void required_argument(const std::string& option)
  {
    usage_error("option needs an argument: " + option);
  }

  /// The argument of an option in another type; ends the program if it is none.
  template <typename T>
  T convert_argument(const std::string& option, const std::string& argument)
  {
    try
    {
      return lexical_cast<T>(argument);
    }
    catch (const std::exception&)
    {
      usage_error("invalid argument for " + option + ": " + argument);
    }
  }

  template <typename T>
  T convert_argument(const std::string& option, const char* argument)
  {
    if (!argument)
      required_argument(option);
    return convert_argument<T>(option, std::string(argument));
  }
}

#include <libport/option-parser.hh>

#endif
