/// What urbiscript calls: functions of objects, and functions that are told of events and variables.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uobject.hh>

#ifndef URBI_UCALLBACKS_HH
#define URBI_UCALLBACKS_HH

#include <functional>
#include <string>

#include <libport/thread-pool.hh>

namespace urbi
{
  /// A function that the host calls. It belongs to its object, and ends with it.
  class UGenericCallback : public UContext
  {
  public:
    UGenericCallback(const UGenericCallback&) = delete;
    UGenericCallback& operator=(const UGenericCallback&) = delete;

    /// The name of the function, event or variable.
    const std::string& getName() const
    {
      return name;
    }

    /// From now on each call is on a thread of its own. \param lock which calls exclude one another;
    /// null for none
    void setAsync(libport::ThreadPool::rTaskLock lock);

    bool isSynchronous() const
    {
      return synchronous_;
    }

    UObject& owner;
    std::string objname;
    std::string name;
    /// The variable, or null.
    UVar* target;
    /// How many arguments it has.
    int nbparam;

  private:
    friend class UObject;

    UGenericCallback(UObject& object, urbi_request operation, const std::string& called,
                     UVar* variable, detail::Callback* callback);

    /// Tells the host of it. \param lock null if it is not threaded
    void tell(const LockSpec* lock);

    urbi_request operation_;
    detail::Callback* callback_;
    bool synchronous_;
  };

  // What the macros of 2.7 were made of.

  /// Has a function called.
  ///
  /// \param type    "function", "event", "var" for changes of a variable or "varaccess" for accesses
  /// \param target  the variable; null for the one of that name
  /// \param name    `object.slot`
  template <typename O, typename F>
  UGenericCallback* createUCallback(UObject& owner, UVar* target, const std::string& type, O* object,
                                    F function, const std::string& name)
  {
    return owner.callback_(type, name, target, detail::bound(object, function));
  }

  /// The same for the beginning and the end of an event: "eventend".
  template <typename O, typename F, typename E>
  UGenericCallback* createUCallback(UObject& owner, UVar*, const std::string& type, O* object,
                                    F function, E end, const std::string& name)
  {
    return owner.callback_(type, name, detail::bound(object, function), detail::bound(object, end));
  }

  /// The same with a function of no object.
  template <typename R, typename... P>
  UGenericCallback* createUCallback(UObject& owner, UVar* target, const std::string& type,
                                    R (*function)(P...), const std::string& name,
                                    impl::UContextImpl* = nullptr)
  {
    return owner.callback_(type, name, target, detail::bound(function));
  }

  template <typename R, typename... P>
  UGenericCallback* createUCallback(UObject& owner, UVar* target, const std::string& type,
                                    const std::function<R(P...)>& function, const std::string& name,
                                    impl::UContextImpl* = nullptr)
  {
    return owner.callback_(type, name, target, detail::bound(function));
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/ucallbacks.hh>
#endif

#endif
