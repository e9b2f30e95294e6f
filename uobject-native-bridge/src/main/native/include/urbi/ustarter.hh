/// Declarations of the classes of a module.
#ifndef URBI_USTARTER_HH
#define URBI_USTARTER_HH

#include <list>
#include <memory>
#include <string>

#include <urbi/detail/host.hh>
#include <urbi/fwd.hh>

/// Declares a class of objects.
#define UStart(Type) UStartRename(Type, Type)

/// Declares a class under another name.
#define UStartRename(Type, Name)                                                                  \
  static ::urbi::URBIStarter<Type> Name##____URBI_object(#Name)

/// Declares a class of which each process has objects of its own.
#define UStartWithID(Type) static ::urbi::URBIStarter<Type> Type##____URBI_object(#Type, true)

/// Declares a class of hubs, of which one instance is made.
#define UStartHub(Type) static ::urbi::URBIStarterHub<Type> Type##____URBI_object(#Type)

namespace urbi
{
  /// A class of objects.
  class baseURBIStarter
  {
  public:
    typedef std::list<baseURBIStarter*> list_type;

    baseURBIStarter(const std::string& className, bool isLocal);

    virtual ~baseURBIStarter();

    baseURBIStarter(const baseURBIStarter&) = delete;
    baseURBIStarter& operator=(const baseURBIStarter&) = delete;

    /// Makes an object.
    virtual UObject* instanciate(const std::string& objectName) = 0;

    static list_type& list();

    std::string name;
    bool local;
  };

  template <class T>
  class URBIStarter : public baseURBIStarter
  {
  public:
    explicit URBIStarter(const std::string& className, bool isLocal = false)
      : baseURBIStarter(className, isLocal)
    {}

    UObject* instanciate(const std::string& objectName) override
    {
      return new T(objectName);
    }
  };

  /// A class of hubs.
  class baseURBIStarterHub
  {
  public:
    typedef std::list<baseURBIStarterHub*> list_type;

    explicit baseURBIStarterHub(const std::string& className);

    virtual ~baseURBIStarterHub();

    baseURBIStarterHub(const baseURBIStarterHub&) = delete;
    baseURBIStarterHub& operator=(const baseURBIStarterHub&) = delete;

    /// Makes the hub.
    virtual UObjectHub* instanciate(const std::string& hubName) = 0;

    static list_type& list();

    std::string name;
  };

  template <class T>
  class URBIStarterHub : public baseURBIStarterHub
  {
  public:
    explicit URBIStarterHub(const std::string& className)
      : baseURBIStarterHub(className)
    {}

    UObjectHub* instanciate(const std::string& hubName) override
    {
      return new T(hubName);
    }
  };
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/ustarter.hh>
#endif

#endif
