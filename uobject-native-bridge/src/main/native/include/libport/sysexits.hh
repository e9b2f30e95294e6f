/// Statuses with which programs end.
#ifndef LIBPORT_SYSEXITS_HH
#define LIBPORT_SYSEXITS_HH

#include <cstdlib>
#include <ostream>
#include <sysexits.h>

/// Something has failed.
#ifndef EX_FAIL
#define EX_FAIL 1
#endif
/// A test is to be skipped.
#ifndef EX_SKIP
#define EX_SKIP 77
#endif
/// A test cannot be run at all.
#ifndef EX_HARD
#define EX_HARD 177
#endif

namespace libport
{
  /// Written to a stream: ends the program.
  class exit
  {
  public:
    explicit exit(int status)
      : status_(status)
    {}

    [[noreturn]] void end(std::ostream& out) const
    {
      out.flush();
      std::exit(status_);
    }

  private:
    int status_;
  };

  [[noreturn]] inline std::ostream& operator<<(std::ostream& out, const exit& status)
  {
    status.end(out);
  }
}

#endif
