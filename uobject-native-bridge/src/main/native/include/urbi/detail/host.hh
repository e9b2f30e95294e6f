/// What a module knows of its host, and how it asks it for something.
#ifndef URBI_DETAIL_HOST_HH
#define URBI_DETAIL_HOST_HH

#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include <urbi/detail/wire.hh>
#include <urbi/export.hh>
#include <urbi/fwd.hh>

namespace urbi
{
  namespace detail
  {
    /// An object that the host has asked for, until the constructor of UObject takes it.
    struct Creation
    {
      int64_t context;
      int64_t id;
      const std::string* className;
      const std::string* name;
      Creation* outer;
    };

    /// The state of a module.
    struct Module
    {
      urbi_host host = nullptr;
      int64_t firstContext = 0;
      /// What has to end before the module is unloaded; they return whether it has.
      std::list<std::function<bool()>> closers;
      std::mutex lock;
      std::list<baseURBIStarter*> starters;
      std::list<baseURBIStarterHub*> hubStarters;
      std::map<std::pair<int64_t, std::string>, UObject*> objects;
      std::map<std::pair<int64_t, std::string>, UObjectHub*> hubs;
    };

    /// The version of the kernel that components of 2.7 ask for.
    enum
    {
      KERNEL_MAJOR = 2,
      KERNEL_MINOR = 7,
    };

    /// Makes an object known by its name.
    template <typename Map, typename T>
    void enlist(Map& all, int64_t context, const std::string& name, T* object)
    {
      typename Map::key_type key(context, name);
      all.erase(key);
      all.insert(typename Map::value_type(key, object));
    }

    URBI_LOCAL Module& module();

    /// A variable of whose value a function is being told: nobody need ask for it.
    struct Told
    {
      const UVar* variable;
      const Told* outer;
    };

    /// What a thread does. Nothing here has a destructor: that would keep the module loaded until the
    /// thread ends.
    struct ThreadState
    {
      int64_t context;
      Creation* creation;
      const Told* told;
      bool destroying; ///< whether a destructor runs, from which no exception may come
      bool sideEffectFree;
    };

    URBI_LOCAL ThreadState& thread_state();

    /// The context that code of this thread belongs to.
    int64_t current_context();

    /// Has a thread belong to a context for a while.
    class InContext
    {
    public:
      explicit InContext(int64_t context)
        : before_(thread_state().context)
      {
        thread_state().context = context;
      }

      ~InContext()
      {
        thread_state().context = before_;
      }

      InContext(const InContext&) = delete;
      InContext& operator=(const InContext&) = delete;

    private:
      int64_t before_;
    };

    /// The host has not done what it was asked for.
    class HostError : public std::runtime_error
    {
    public:
      using std::runtime_error::runtime_error;
    };

    /// One request to the host: write the arguments, send it, read the reply.
    class Request
    {
    public:
      Request(urbi_request operation, int64_t context, int64_t subject = 0);

      ~Request();

      Request(const Request&) = delete;
      Request& operator=(const Request&) = delete;

      /// \throw HostError
      int64_t send();

      /// What the host has answered; it lives as long as this request.
      Reader reply() const
      {
        return Reader(exchange_.reply, exchange_.reply_length);
      }

      Writer out;

    private:
      static const size_t SIZE = 256;

      urbi_exchange exchange_;
      uint8_t arguments_[SIZE];
      uint8_t answer_[SIZE];
    };
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/host.hh>
#endif

#endif
