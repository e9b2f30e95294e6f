/// Objects of C++ that are objects of urbiscript (manual, "The UObject API").
#ifndef URBI_UOBJECT_HH
#define URBI_UOBJECT_HH

#include <string>

#include <urbi/detail/for-each.hh>
#include <urbi/detail/resident.hh>
#include <urbi/export.hh>
#include <urbi/fwd.hh>
#include <urbi/input-port.hh>
#include <urbi/lock-mode.hh>
#include <urbi/ublend-type.hh>
#include <urbi/ucontext.hh>
#include <urbi/uevent.hh>
#include <urbi/uobject-hub.hh>
#include <urbi/uvar.hh>

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

/// Registers this object with a hub.
#define URegister(Hub) (this->register_(#Hub))

// ------------------------------------------------------------------ urbiscript

/// Sends code: URBI((...)), or URBI(()) << ... .
#ifndef URBI
#define URBI(A) uobject_unarmorAndSend(#A)
#endif

#define URBI_SEND(Args) (URBI(()) << Args)
#define URBI_SEND_COMMAND(Args) (URBI(()) << Args << ';')
#define URBI_SEND_COMMA_COMMAND(Args) (URBI(()) << Args << ',')
#define URBI_SEND_PIPED_COMMAND(Args) (URBI(()) << Args << "|\n")

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
    explicit UObject(const std::string& name);

    /// An object that C++ code makes by itself; urbiscript gets one as well.
    UObject();
    explicit UObject(int);
    ~UObject() override;

    /// Has a function called after each change of a variable. It takes nothing, a UVar&, or the value
    /// in any type.
    template <typename F>
    void UNotifyChange(UVar& v, F function)
    {
      notify(URBI_VARIABLE_CHANGE, v, function, nullptr);
    }

    /// \param name  `object.slot`, or a slot of this object
    template <typename F>
    void UNotifyChange(const std::string& name, F function)
    {
      notify(URBI_VARIABLE_CHANGE, name, function, nullptr);
    }

    /// Has a function called on a thread of its own after each change. It takes nothing, or the value.
    template <typename F>
    void UNotifyThreadedChange(UVar& v, F function, LockSpec lock)
    {
      check_threaded(function);
      notify(URBI_VARIABLE_CHANGE, v, function, &lock);
    }

    template <typename F>
    void UNotifyThreadedChange(const std::string& name, F function, LockSpec lock)
    {
      check_threaded(function);
      notify(URBI_VARIABLE_CHANGE, name, function, &lock);
    }

    /// Has a function called before each access to a variable, so that it may set the value.
    template <typename F>
    void UNotifyAccess(UVar& v, F function)
    {
      notify(URBI_VARIABLE_ACCESS, v, function, nullptr);
    }

    template <typename F>
    void UNotifyAccess(const std::string& name, F function)
    {
      notify(URBI_VARIABLE_ACCESS, name, function, nullptr);
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
    virtual void addAutoGroup()
    {
      UJoinGroup(classname + "s");
    }

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
    UObjectList members;
    /// The hub with which it has registered last, or null.
    UObjectHub* objecthub;
    /// How active the object is to be: 1 unless changed.
    UVar load;

    // What the macros use.

    template <typename F>
    void bindFunction_(const std::string& name, F function)
    {
      bind(name, function, nullptr);
    }

    template <typename F>
    void bindThreadedFunction_(const std::string& name, F function, LockSpec lock)
    {
      bind(name, function, &lock);
    }

    template <typename F>
    void at_(const std::string& event, F function)
    {
      bind(at(event), function, nullptr);
      listen(event, detail::arity_of(function), false);
    }

    template <typename F>
    void threadedAt_(const std::string& event, F function, LockSpec lock)
    {
      bind(at(event), function, &lock);
      listen(event, detail::arity_of(function), false);
    }

    template <typename F, typename E>
    void atEnd_(const std::string& event, F function, E end)
    {
      bind(at(event), function, nullptr);
      bind(at_end(event), end, nullptr);
      listen(event, detail::arity_of(function), true);
    }

    template <typename F, typename E>
    void threadedAtEnd_(const std::string& event, F function, E end, LockSpec lock)
    {
      bind(at(event), function, &lock);
      bind(at_end(event), end, &lock);
      listen(event, detail::arity_of(function), true);
    }

    void register_(const std::string& hubClass);

  private:
    friend class detail::Creator;

    /// By which names urbiscript calls the functions that are told of an event.
    static std::string at(const std::string& event)
    {
      return "__at_" + event;
    }

    static std::string at_end(const std::string& event)
    {
      return "__atEnd_" + event;
    }

    /// Has functions that were bound called with each emission of an event.
    void listen(const std::string& event, size_t arity, bool end);

    template <typename F>
    void bind(const std::string& name, F function, const LockSpec* lock)
    {
      detail::Callback* callback = own(detail::function_callback(this, function));
      detail::Request request(URBI_FUNCTION, ctx_, id_);
      request.out.text(name);
      write_callback(request.out, callback, lock);
      request.send();
    }

    template <typename F>
    void notify(urbi_request operation, UVar& v, F function, const LockSpec* lock)
    {
      v.check();
      // A variable that is an argument ends with the call: this one stays.
      UVar* kept = v.get_temp() ? new UVar(v) : &v;
      notify(operation, detail::notification_callback(this, function, kept, v.get_temp()), *kept,
             lock);
    }

    template <typename F>
    void notify(urbi_request operation, const std::string& name, F function, const LockSpec* lock)
    {
      UVar* made = new UVar();
      std::unique_ptr<detail::Callback> callback
        = detail::notification_callback(this, function, made, true);
      made->init(name.find('.') == std::string::npos ? __name + "." + name : name, ctx_);
      notify(operation, std::move(callback), *made, lock);
    }

    void notify(urbi_request operation, std::unique_ptr<detail::Callback> made, UVar& v,
                const LockSpec* lock)
    {
      detail::Callback* callback = own(std::move(made));
      detail::Request request(operation, ctx_, v.slot_);
      request.out.raw(id_);
      write_callback(request.out, callback, lock);
      request.send();
    }

    template <typename R, typename C, typename... P>
    static void check_threaded(R (C::*)(P...))
    {
      static_assert(!(std::is_base_of<UVar, detail::plain<P>>::value || ...),
                    "a threaded notification takes the value: the UVar may have changed again");
    }

    template <typename R, typename C, typename... P>
    static void check_threaded(R (C::*)(P...) const)
    {
      static_assert(!(std::is_base_of<UVar, detail::plain<P>>::value || ...),
                    "a threaded notification takes the value: the UVar may have changed again");
    }

    void attach(const std::string& name);

    /// Whether the host knows that it ends.
    bool ended_;
  };
}

#include <urbi/ustarter.hh>

#include <urbi/detail/uobject.hxx>

#include <urbi/detail/entry.hh>

#endif
