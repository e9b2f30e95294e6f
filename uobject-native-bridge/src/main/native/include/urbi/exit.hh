/// An exception that ends a program.
#ifndef URBI_EXIT_HH
#define URBI_EXIT_HH

#include <exception>
#include <string>

#include <urbi/export.hh>

namespace urbi
{
  /// Ends a program with a status and a message.
  class Exit : public std::exception
  {
  public:
    Exit(int error, const std::string& message)
      : error_(error)
      , message_(message)
    {}

    const char* what() const noexcept override
    {
      return message_.c_str();
    }

    int error_get() const
    {
      return error_;
    }

  private:
    int error_;
    std::string message_;
  };
}

#endif
