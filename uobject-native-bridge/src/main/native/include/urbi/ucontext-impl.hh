/// A context: where objects, variables and events live.
#ifndef URBI_UCONTEXT_IMPL_HH
#define URBI_UCONTEXT_IMPL_HH

#include <atomic>
#include <mutex>
#include <string>

#include <dlfcn.h>

#include <libport/asio.hh>
#include <libport/foreach.hh>
#include <libport/utime.hh>

#include <urbi/detail/host.hh>
#include <urbi/fwd.hh>

namespace urbi
{
  /// Where the objects of this module live.
  enum UObjectMode
  {
    MODE_PLUGIN = 1, ///< in the process of the kernel
    MODE_REMOTE = 2, ///< in another one
  };

  /// Microseconds.
  typedef libport::utime_t utime_t;

  namespace detail
  {
    void send_text(int64_t context, const std::string& code);

    /// Where this module is loaded to, while it is: its host cannot be asked before its static
    /// variables have been initialized. An even number of `/.` in its path stands for a remote process.
    UObjectMode loading_mode();

    UObjectMode running_mode(int64_t context);

    void yield_for(int64_t context, libport::utime_t microseconds);

    /// Where the server is to which this process is connected: false in the process of a kernel.
    bool server(int64_t context, std::string& host, unsigned& port);
  }
}

/// Lets everything else go on for so long. By this symbol the host knows that the module does so: see
/// boundary.h.
URBI_ENTRY_IF_USED void urbi_module_yield(int64_t context, int64_t microseconds)
{
  urbi::detail::yield_for(context, microseconds);
}

namespace urbi
{

  namespace impl
  {
    /// What `ctx_` points to. There is one for each context, which lives as long as the module.
    class UContextImpl
    {
    public:
      explicit UContextImpl(int64_t number)
        : next(nullptr)
        , number_(number)
      {}

      UContextImpl(const UContextImpl&) = delete;
      UContextImpl& operator=(const UContextImpl&) = delete;

      int64_t number() const
      {
        return number_;
      }

      /// Has the context do nothing but what this thread asks for, until `unlock`.
      void lock()
      {
        detail::Request(URBI_LOCK, number_).send();
      }

      void unlock()
      {
        detail::Request(URBI_UNLOCK, number_).send();
      }

      void send(const std::string& code)
      {
        detail::send_text(number_, code);
      }

      void send(const char* code)
      {
        detail::send_text(number_, code);
      }

      void send(const void* code, size_t size)
      {
        detail::send_text(number_, std::string(static_cast<const char*>(code), size));
      }

      // Defined with UObject.
      UObject* getUObject(const std::string& name);
      UObjectHub* getUObjectHub(const std::string& name);

      UObjectMode getRunningMode() const
      {
        return detail::running_mode(number_);
      }

      void yield() const
      {
        urbi_module_yield(number_, 0);
      }

      void yield_for(libport::utime_t microseconds) const
      {
        urbi_module_yield(number_, microseconds);
      }

      void yield_until(libport::utime_t deadline) const
      {
        urbi_module_yield(number_, deadline - libport::utime());
      }

      void yield_until_things_changed() const
      {
        urbi_module_yield(number_, 0);
      }

      /// The next context of this module.
      UContextImpl* next;

    private:
      int64_t number_;
    };
  }

  namespace detail
  {
    /// The contexts of this module: few, and none goes before the module does.
    struct Contexts
    {
      ~Contexts()
      {
        for (impl::UContextImpl* each = first; each;)
        {
          impl::UContextImpl* gone = each;
          each = each->next;
          delete gone;
        }
      }

      std::atomic<impl::UContextImpl*> first{nullptr};
      std::mutex adding;
    };

    URBI_LOCAL Contexts& contexts();

    impl::UContextImpl* find_context(int64_t number);

    /// The context of that number; null for 0.
    impl::UContextImpl* context_of(int64_t number);
  }

  /// The context that code of this thread belongs to; null for none.
  impl::UContextImpl* getCurrentContext();

  /// From now on code of this thread belongs to it.
  void setCurrentContext(impl::UContextImpl* context);
}

#include <urbi/ucontext.hh>

#endif
