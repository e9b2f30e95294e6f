#ifndef UMACHINE_HH
#define UMACHINE_HH

#include <urbi/uobject.hh>

#include "machine.hh"

/// The machine as urbiscript sees it.
class UMachine : public urbi::UObject
{
public:
  /// For every object, the prototype included.
  explicit UMachine(const std::string& name);

  /// For every object that is made by new.
  int init(urbi::ufloat duration);

  std::string assemble(const std::list<std::string>& parts);

private:
  /// The variable `duration` was written.
  void durationChanged();

  Machine machine;
  urbi::UVar duration;
};

#endif
