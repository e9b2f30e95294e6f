#include "umachine.hh"

UStart(UMachine);

UMachine::UMachine(const std::string& name)
  : urbi::UObject(name)
  , machine(0)
{
  UBindFunctions(UMachine, init, assemble);
  UBindThreadedFunctionRename
    (UMachine, assemble, "threadedAssemble", urbi::LOCK_FUNCTION);
}

int UMachine::init(urbi::ufloat d)
{
  if (d < 0)
    return 1;
  UBindVar(UMachine, duration);
  UNotifyChange(duration, &UMachine::durationChanged);
  duration = d;
  return 0;
}

std::string UMachine::assemble(const std::list<std::string>& parts)
{
  return machine(parts);
}

void UMachine::durationChanged()
{
  machine.duration = duration;
}
