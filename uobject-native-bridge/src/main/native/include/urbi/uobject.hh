/// Objects of C++ that are objects of urbiscript (manual, "The UObject API").
#ifndef URBI_UOBJECT_HH
#define URBI_UOBJECT_HH

// What the headers of 2.7 brought along: components use it without saying so.
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <libport/asio.hh>
#include <libport/cassert>
#include <libport/cmath>
#include <libport/compiler.hh>
#include <libport/containers.hh>
#include <libport/debug.hh>
#include <libport/foreach.hh>
#include <libport/format.hh>
#include <libport/lockable.hh>
#include <libport/thread-pool.hh>
#include <libport/ufloat.h>
#include <libport/unistd.h>
#include <libport/utime.hh>

#include <urbi/detail/for-each.hh>
#include <urbi/detail/resident.hh>
#include <urbi/export.hh>
#include <urbi/fwd.hh>
#include <urbi/input-port.hh>
#include <urbi/kernel-version.hh>
#include <urbi/lock-mode.hh>
#include <urbi/ublend-type.hh>
#include <urbi/ucontext.hh>
#include <urbi/uevent.hh>
#include <urbi/uobject-hub.hh>
#include <urbi/uvar.hh>
#include <urbi/version-check.hh>

// Functions may return nothing.
#define USE_VOID 1
#define URBI_UOBJECT_VERSION 2

// ------------------------------------------------------------------ variables and events

/// Makes a UVar a slot of this object.
#define UBindVarRename(Obj, X, Uname) ((X).init(__name, Uname, ctx_))
#define UBindVar(Obj, X) UBindVarRename(Obj, X, #X)
#define UBindVars(Obj, ...)                                                                       \
  do                                                                                              \
  {                                                                                               \
    URBI_FOR_EACH(URBI_BIND_VAR_, Obj, __VA_ARGS__)                                               \
  } while (false)
#define URBI_BIND_VAR_(Obj, X) UBindVar(Obj, X);

/// Makes a UEvent a slot of this object.
#define UBindEventRename(Obj, X, Uname) ((X).init(__name, Uname, ctx_))
#define UBindEvent(Obj, X) UBindEventRename(Obj, X, #X)
#define UBindEvents(Obj, ...)                                                                     \
  do                                                                                              \
  {                                                                                               \
    URBI_FOR_EACH(URBI_BIND_EVENT_, Obj, __VA_ARGS__)                                             \
  } while (false)
#define URBI_BIND_EVENT_(Obj, X) UBindEvent(Obj, X);

/// Gives a variable two values: this module reads the target that others have written, and what it
/// writes is what they read.
#define UOwned(X) ((X).setOwned())
#define Uowned(X) UOwned(X)
#define USensor(X) UOwned(X)

// ------------------------------------------------------------------ functions

/// Makes a member function a function of the urbiscript object.
#define UBindFunctionRename(Obj, X, Uname) (this->bindFunction_(Uname, &Obj::X))
#define UBindFunction(Obj, X) UBindFunctionRename(Obj, X, #X)
#define UBindFunctions(Obj, ...)                                                                  \
  do                                                                                              \
  {                                                                                               \
    URBI_FOR_EACH(URBI_BIND_FUNCTION_, Obj, __VA_ARGS__)                                          \
  } while (false)
#define URBI_BIND_FUNCTION_(Obj, X) UBindFunction(Obj, X);

/// The same, with each call on a thread of its own. \a Lock is a LockMode or a LockSpec.
#define UBindThreadedFunctionRename(Obj, X, Uname, Lock)                                          \
  (this->bindThreadedFunction_(Uname, &Obj::X, Lock))
#define UBindThreadedFunction(Obj, X, Lock) UBindThreadedFunctionRename(Obj, X, #X, Lock)

/// Has a member function called with each emission of the event of that name which has as many
/// arguments. The object has such an event from now on.
#define UAt(Obj, X) (this->at_(#X, &Obj::X))
/// The same, and \a Fun, which takes nothing, when it ends.
#define UAtEnd(Obj, X, Fun) (this->atEnd_(#X, &Obj::X, &Obj::Fun))
/// The same, with each call on a thread of its own. \a Lock is a LockMode or a LockSpec.
#define UThreadedAt(Obj, X, Lock) (this->threadedAt_(#X, &Obj::X, Lock))
#define UThreadedAtEnd(Obj, X, Fun, Lock) (this->threadedAtEnd_(#X, &Obj::X, &Obj::Fun, Lock))

/// Gives the threaded functions of a class that are bound with LOCK_CLASS a lock of that class.
#define CREATE_CLASS_LOCK                                                                         \
  ::libport::ThreadPool::rTaskLock getClassTaskLock() override                                    \
  {                                                                                               \
    return this->getTaskLock(::urbi::LOCK_CLASS, "");                                             \
  }

/// Registers this object with a hub.
#define URegister(Hub) (this->register_(#Hub))

// ------------------------------------------------------------------ urbiscript

/// Sends code: URBI((...)), or URBI(()) << ... . Whatever was included before: a UObject uses its context,
/// and no client.
#undef URBI
#define URBI(A) uobject_unarmorAndSend(#A)

#define URBI_SEND(Args) (URBI(()) << Args)
#define URBI_SEND_COMMAND(Args) (URBI(()) << Args << ';')
#define URBI_SEND_COMMA_COMMAND(Args) (URBI(()) << Args << ',')
#define URBI_SEND_PIPED_COMMAND(Args) (URBI(()) << Args << "|\n")

/// The same to a client, or whatever else is a stream.
#define URBI_SEND_C(Client, Args) static_cast<void>((Client) << Args)
#define URBI_SEND_C_FLUSH(Client, Args) static_cast<void>((Client) << Args << std::endl)
#define URBI_SEND_COMMAND_C(Client, Args) URBI_SEND_C_FLUSH(Client, Args << ';')
#define URBI_SEND_COMMA_COMMAND_C(Client, Args) URBI_SEND_C_FLUSH(Client, Args << ',')
#define URBI_SEND_PIPED_COMMAND_C(Client, Args) URBI_SEND_C(Client, Args << "|\n")

namespace urbi
{
  typedef int UReturn;

  /// An object of urbiscript that is written in C++. A subclass has a constructor that takes its
  /// name, is declared by UStart, and binds what urbiscript may see of it.
  class UObject : public detail::Resident
  {
  public:
    /// An object that urbiscript or the kernel makes.
    ///
    /// \param name  as it is given to the constructor of the subclass
    explicit UObject(const std::string& name, impl::UContextImpl* context = nullptr);

    /// An object that C++ code makes by itself; urbiscript gets one as well.
    UObject(impl::UContextImpl* context = nullptr);
    explicit UObject(int, impl::UContextImpl* context = nullptr);
    ~UObject() override;

    /// Has a function called after each change of a variable. It takes nothing, a UVar&, or the value
    /// in any type.
    ///
    /// \param v  the variable, or its name: `object.slot`, or a slot of this object
    template <typename V, typename F>
    void UNotifyChange(V&& v, F function)
    {
      notify(URBI_VARIABLE_CHANGE, v, function, nullptr);
    }

    /// The same on a thread of its own. What takes a UVar& reads what it is by then.
    template <typename V, typename F>
    void UNotifyThreadedChange(V&& v, F function, LockSpec lock)
    {
      notify(URBI_VARIABLE_CHANGE, v, function, &lock);
    }

    /// Has a function called before each access to a variable, so that it may set the value.
    template <typename V, typename F>
    void UNotifyAccess(V&& v, F function)
    {
      notify(URBI_VARIABLE_ACCESS, v, function, nullptr);
    }

    /// The same on a thread of its own: whoever reads the variable does not wait for it.
    template <typename V, typename F>
    void UNotifyThreadedAccess(V&& v, F function, LockSpec lock)
    {
      notify(URBI_VARIABLE_ACCESS, v, function, &lock);
    }

    /// The former name of UNotifyAccess.
    template <typename V, typename F>
    void UNotifyOnRequest(V&& v, F function)
    {
      UNotifyAccess(std::forward<V>(v), function);
    }

    /// Has each change of a variable sent here.
    void USync(UVar& v)
    {
      v.keepSynchronized();
    }

    /// Puts this object into a group of urbiscript, which is made if there is none of that name.
    virtual void UJoinGroup(const std::string& groupName);

    /// Puts this object into the groups in which it always is.
    void UAutoGroup()
    {
      addAutoGroup();
    }

    /// That of its class, by the plural of its name, unless a subclass knows better.
    virtual void addAutoGroup();

    /// Ends all that it has bound. Nothing can be done with it afterwards but to delete it.
    void clean();

    int voidfun()
    {
      return 0;
    }

    /// Its name in urbiscript, a slot of `uobjects`.
    std::string __name;
    /// The name of its class in urbiscript.
    std::string classname;
    /// Whether urbiscript has made it by `new`: false for the first one, the prototype.
    bool derived;
    bool remote;
    /// Of no effect.
    bool autogroup;
    UObjectList members;
    /// The hub with which it has registered last, or null.
    UObjectHub* objecthub;
    /// How active the object is to be: 1 unless changed.
    UVar load;

    /// The tasks that a threaded function excludes, for UGenericCallback::setAsync.
    libport::ThreadPool::rTaskLock getTaskLock(LockSpec lock, const std::string& function);

    /// A subclass may have a lock of its own; CREATE_CLASS_LOCK does it. Each class has one anyway.
    virtual libport::ThreadPool::rTaskLock getClassTaskLock();

    /// Who has made it: null if C++ code has by itself.
    baseURBIStarter* cloner;

    // What the macros use.

    template <typename F>
    UGenericCallback* bindFunction_(const std::string& name, F function)
    {
      return bind(name, detail::bound(this, function).function(), nullptr);
    }

    template <typename F>
    UGenericCallback* bindThreadedFunction_(const std::string& name, F function, LockSpec lock)
    {
      return bind(name, detail::bound(this, function).function(), &lock);
    }

    template <typename F>
    UGenericCallback* at_(const std::string& event, F function)
    {
      return bindAt(event, detail::bound(this, function), nullptr);
    }

    template <typename F>
    UGenericCallback* threadedAt_(const std::string& event, F function, LockSpec lock)
    {
      return bindAt(event, detail::bound(this, function), &lock);
    }

    template <typename F, typename E>
    UGenericCallback* atEnd_(const std::string& event, F function, E end)
    {
      return bindAtEnd(event, detail::bound(this, function), detail::bound(this, end), nullptr);
    }

    template <typename F, typename E>
    UGenericCallback* threadedAtEnd_(const std::string& event, F function, E end, LockSpec lock)
    {
      return bindAtEnd(event, detail::bound(this, function), detail::bound(this, end), &lock);
    }

    void register_(const std::string& hubClass);

    /// What createUCallback does, see there.
    template <typename S>
    UGenericCallback* callback_(const std::string& type, const std::string& name, UVar* target,
                                const S& function);

    template <typename S, typename E>
    UGenericCallback* callback_(const std::string& type, const std::string& name, const S& function,
                                const E& end);

  private:
    friend class detail::Creator;
    friend class UGenericCallback;

    /// By which names urbiscript calls the functions that are told of an event.
    static std::string at(const std::string& event);

    static std::string at_end(const std::string& event);

    /// Has functions that were bound called with each emission of an event.
    void listen(const std::string& event, size_t arity, bool end);

    /// A slot of this object, without its name.
    std::string own_slot(const std::string& name) const;

    UGenericCallback* bind(const std::string& name, std::unique_ptr<detail::Callback> function,
                           const LockSpec* lock)
    {
      return hold(URBI_FUNCTION, name, nullptr, std::move(function), lock);
    }

    template <typename S>
    UGenericCallback* bindAt(const std::string& event, const S& function, const LockSpec* lock)
    {
      UGenericCallback* made = bind(at(event), function.function(), lock);
      listen(event, S::arity, false);
      return made;
    }

    template <typename S, typename E>
    UGenericCallback* bindAtEnd(const std::string& event, const S& function, const E& end,
                                const LockSpec* lock)
    {
      UGenericCallback* made = bind(at(event), function.function(), lock);
      bind(at_end(event), end.function(), lock);
      listen(event, S::arity, true);
      return made;
    }

    template <typename F>
    UGenericCallback* notify(urbi_request operation, UVar& v, F function, const LockSpec* lock)
    {
      return notifySigned(operation, v, detail::bound(this, function), lock);
    }

    template <typename F>
    UGenericCallback* notify(urbi_request operation, const std::string& name, F function,
                             const LockSpec* lock)
    {
      return notifySigned(operation, name, detail::bound(this, function), lock);
    }

    template <typename S>
    UGenericCallback* notifySigned(urbi_request operation, UVar& v, const S& function,
                                   const LockSpec* lock)
    {
      v.check();
      // A variable that is an argument ends with the call: this one stays.
      UVar* kept = v.get_temp() ? new UVar(v) : &v;
      std::unique_ptr<detail::Callback> made = function.notification(kept, v.get_temp());
      return hold(operation, v.get_name(), kept, std::move(made), lock);
    }

    template <typename S>
    UGenericCallback* notifySigned(urbi_request operation, const std::string& name,
                                   const S& function, const LockSpec* lock)
    {
      UVar* kept = new UVar();
      std::unique_ptr<detail::Callback> made = function.notification(kept, true);
      kept->init(name.find('.') == std::string::npos ? __name + "." + name : name, ctx_);
      return hold(operation, kept->get_name(), kept, std::move(made), lock);
    }

    /// Has the host call it from now on.
    UGenericCallback* hold(urbi_request operation, const std::string& name, UVar* target,
                           std::unique_ptr<detail::Callback> function, const LockSpec* lock);

    void attach(const std::string& name);

    /// Whether the host knows that it ends.
    bool ended_;
    std::mutex holding_;
    std::list<std::unique_ptr<UGenericCallback>> held_;
  };
}

#include <urbi/ucallbacks.hh>
#include <urbi/ustarter.hh>

#include <urbi/detail/uobject.hxx>

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/uobject.hh>
#include <urbi/detail/entry.hh>
#else
// Has a module export what stands there.
extern "C" int64_t urbi_module_version();
static int64_t (*const urbi_module_entry)() __attribute__((used)) = urbi_module_version;
#endif

#endif
