#ifndef MACHINE_HH
#define MACHINE_HH

#include <list>
#include <string>

/// A machine that takes its time to put parts together. It knows nothing of urbiscript.
class Machine
{
public:
  /// \param duration  how long an assembly takes, in seconds
  explicit Machine(double duration);

  /// One string of all the parts, when the time has passed.
  std::string operator()(const std::list<std::string>& parts) const;

  double duration;
};

#endif
