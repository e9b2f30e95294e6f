/// What a module exports: see boundary.h.
#ifndef URBI_DETAIL_ENTRY_HH
#define URBI_DETAIL_ENTRY_HH

#include <cstdlib>
#include <exception>
#include <string>

#include <urbi/detail/host.hh>
#include <urbi/export.hh>
#include <urbi/uobject.hh>

namespace urbi
{
  namespace detail
  {
    /// The exception that is being handled, for people.
    inline std::string current_exception_text()
    {
      try
      {
        throw;
      }
      catch (const std::exception& e)
      {
        return e.what();
      }
      catch (...)
      {
        return "invalid exception";
      }
    }

    /// Whether the exception that is being handled is one of the host.
    inline bool is_host_error()
    {
      try
      {
        throw;
      }
      catch (const HostError&)
      {
        return true;
      }
      catch (...)
      {
        return false;
      }
    }

    /// Hands a reply over to the host.
    inline void answer(urbi_exchange* exchange, Writer& out)
    {
      exchange->reply_length = out.size();
      exchange->reply = out.release();
    }

    /// Carries out a call of the host; no exception leaves the module.
    template <typename Function>
    int64_t entered(urbi_exchange* exchange, const Function& function) noexcept
    {
      ThreadState before = thread_state();
      thread_state().context = exchange->context;
      Writer out(exchange->reply, exchange->reply_capacity, true);
      int64_t result;
      try
      {
        Reader in(exchange->data, exchange->length);
        result = function(in, out);
      }
      catch (...)
      {
        result = URBI_FAILED;
        if (is_host_error())
          exchange->operation = URBI_PASSED;
        std::string text = current_exception_text();
        out.restart();
        try
        {
          out.bytes(text.data(), text.size());
        }
        catch (const std::bad_alloc&)
        {
          // There is always room for some of it in the host's buffer.
          out.bytes(text.data(), static_cast<size_t>(exchange->reply_capacity));
        }
      }
      answer(exchange, out);
      thread_state() = before;
      return result;
    }

    /// Makes and ends objects for the host.
    class Creator
    {
    public:
      static int64_t create(urbi_exchange* exchange, Reader& in)
      {
        std::string className = in.text();
        std::string name = in.text();
        {
          std::lock_guard<std::mutex> guard(module().lock);
          if (!module().firstContext)
            module().firstContext = exchange->context;
        }
        ThreadState& state = thread_state();
        Creation creation = {exchange->context, exchange->subject, &className, &name, nullptr};
        state.creation = &creation;
        if (exchange->operation)
          return address(starter(baseURBIStarterHub::list(), className)->instanciate(name));
        return address(starter(baseURBIStarter::list(), className)->instanciate(name));
      }

      static void destroy(urbi_exchange* exchange)
      {
        thread_state().destroying = true;
        intptr_t at = static_cast<intptr_t>(exchange->subject);
        if (exchange->operation)
        {
          delete reinterpret_cast<UObjectHub*>(at);
          return;
        }
        UObject* object = reinterpret_cast<UObject*>(at);
        object->ended_ = true;
        delete object;
      }

    private:
      static int64_t address(void* object)
      {
        return static_cast<int64_t>(reinterpret_cast<intptr_t>(object));
      }

      template <typename List>
      static typename List::value_type starter(const List& all, const std::string& className)
      {
        for (typename List::value_type each : all)
          if (each->name == className)
            return each;
        throw std::runtime_error("no class " + className);
      }
    };
  }
}

URBI_ENTRY int64_t urbi_module_version()
{
  return URBI_BOUNDARY_VERSION;
}

URBI_ENTRY int64_t urbi_module_open(urbi_host host, urbi_exchange* exchange)
{
  return urbi::detail::entered(exchange, [=](urbi::detail::Reader&, urbi::detail::Writer& out) {
    urbi::detail::module().host = host;
    for (const urbi::baseURBIStarterHub* each : urbi::baseURBIStarterHub::list())
    {
      out.text("hub");
      out.text(each->name);
    }
    for (const urbi::baseURBIStarter* each : urbi::baseURBIStarter::list())
    {
      out.text("class");
      out.text(each->name);
    }
    return int64_t(0);
  });
}

URBI_ENTRY int64_t urbi_module_create(urbi_exchange* exchange)
{
  return urbi::detail::entered(exchange, [=](urbi::detail::Reader& in, urbi::detail::Writer&) {
    return urbi::detail::Creator::create(exchange, in);
  });
}

URBI_ENTRY int64_t urbi_module_destroy(urbi_exchange* exchange)
{
  return urbi::detail::entered(exchange, [=](urbi::detail::Reader&, urbi::detail::Writer&) {
    urbi::detail::Creator::destroy(exchange);
    return int64_t(0);
  });
}

URBI_ENTRY int64_t urbi_module_invoke(urbi_exchange* exchange)
{
  return urbi::detail::entered(exchange, [=](urbi::detail::Reader& in, urbi::detail::Writer& out) {
    intptr_t at = static_cast<intptr_t>(exchange->subject);
    reinterpret_cast<urbi::detail::Callback*>(at)->call(in, out);
    return int64_t(0);
  });
}

URBI_ENTRY int64_t urbi_module_forget(urbi_exchange* exchange)
{
  return urbi::detail::entered(exchange, [=](urbi::detail::Reader&, urbi::detail::Writer&) {
    urbi::detail::Module& module = urbi::detail::module();
    bool ended = true;
    for (const std::function<bool()>& close : module.closers)
      ended = close() && ended;
    std::lock_guard<std::mutex> guard(module.lock);
    if (module.firstContext == exchange->context)
      module.firstContext = 0;
    return int64_t(ended);
  });
}

URBI_ENTRY void urbi_module_free(void* reply)
{
  std::free(reply);
}

#endif
