/// Declarations of what urbi/uobject.hh defines.
#ifndef URBI_FWD_HH
#define URBI_FWD_HH

#include <list>
#include <string>
#include <unordered_map>

namespace urbi
{
  /// Numbers are doubles, as in urbiscript.
  typedef double ufloat;

  class InputPort;
  class UAbstractClient;
  class UBinary;
  class UClient;
  class UEvent;
  class UImage;
  class UImageImpl;
  class UList;
  class UMessage;
  class UObject;
  class UObjectHub;
  class UProp;
  class USound;
  class USoundImpl;
  class USyncClient;
  class UValue;
  class UVar;
  class baseURBIStarter;
  class baseURBIStarterHub;

  typedef std::unordered_map<std::string, UValue> UDictionary;
  typedef std::list<UObject*> UObjectList;
}

#endif
