/// Declarations of what urbi/uobject.hh defines.
#ifndef URBI_FWD_HH
#define URBI_FWD_HH

#include <list>
#include <memory>
#include <string>
#include <unordered_map>

#include <libport/boost-names.hh>
#include <libport/ufloat.h>

#include <urbi/export.hh>

namespace urbi
{
  /// Numbers are doubles, as in urbiscript.
  typedef double ufloat;

  namespace impl
  {
    class UContextImpl;
    class UGenericCallbackImpl;
    class UObjectImpl;
    class UVarImpl;
  }

  class UContext;
  class UGenericCallback;

  class InputPort;
  class UAbstractClient;
  class UBinary;
  class UCallbackList;
  class UCallbackWrapper;
  class UClient;
  class UEvent;
  class UImage;
  class UImageImpl;
  class UList;
  class UMessage;
  class UObject;
  class UObjectData;
  class UObjectHub;
  class UProp;
  class USound;
  class USoundImpl;
  class USyncClient;
  class UTimerCallback;
  class UValue;
  class UVar;
  class UVardata;
  class UVariable;
  class baseURBIStarter;
  class baseURBIStarterHub;

  typedef std::unordered_map<std::string, UValue> UDictionary;
  typedef std::list<UObject*> UObjectList;

  /// A timer that USetTimer has set: its name.
  typedef std::shared_ptr<std::string> TimerHandle;

  std::string getClientConnectionID(const UAbstractClient* client);
  UClient* getDefaultClient();
}

#endif
