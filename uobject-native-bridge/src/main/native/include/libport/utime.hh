/// Times in microseconds.
#ifndef LIBPORT_UTIME_HH
#define LIBPORT_UTIME_HH

#include <chrono>
#include <cstdint>

namespace libport
{
  /// Microseconds.
  typedef long long utime_t;

  /// Now, since some moment that stays the same while the process runs.
  inline utime_t utime()
  {
    return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }

  inline utime_t seconds_to_utime(double seconds)
  {
    return static_cast<utime_t>(seconds * 1000000.0);
  }

  inline utime_t milliseconds_to_utime(double milliseconds)
  {
    return static_cast<utime_t>(milliseconds * 1000.0);
  }

  inline double utime_to_seconds(utime_t time)
  {
    return static_cast<double>(time) / 1000000.0;
  }
}

#endif
