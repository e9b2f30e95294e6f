/// What urbi/detail/host.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/detail/host.hh>

#ifndef URBI_DETAIL_CODE_HOST_HH
#define URBI_DETAIL_CODE_HOST_HH

namespace urbi
{
  namespace detail
  {
    URBI_STATE Module& module()
    {
      static Module all;
      return all;
    }

    URBI_STATE ThreadState& thread_state()
    {
      static thread_local ThreadState state;
      return state;
    }

    URBI_INLINE int64_t current_context()
    {
      int64_t own = thread_state().context;
      return own ? own : module().firstContext;
    }

    URBI_INLINE Request::Request(urbi_request operation, int64_t context, int64_t subject)
      : out(arguments_, sizeof arguments_, false)
    {
      exchange_.operation = operation;
      exchange_.context = context;
      exchange_.subject = subject;
      exchange_.reply = answer_;
      exchange_.reply_capacity = sizeof answer_;
      exchange_.reply_length = 0;
    }

    URBI_INLINE Request::~Request()
    {
      if (exchange_.reply != answer_)
        std::free(exchange_.reply);
    }

    URBI_INLINE int64_t Request::send()
    {
      urbi_host host = module().host;
      if (!host)
        throw std::runtime_error("this module has no host: let urbi-launch load it");
      exchange_.data = out.data();
      exchange_.length = out.size();
      int64_t result = host(&exchange_);
      if (result == URBI_FAILED && thread_state().destroying)
      {
        // The kernel may have ended already. Whoever reads a value gets the number 0.
        if (exchange_.reply != answer_)
          std::free(exchange_.reply);
        exchange_.reply = answer_;
        Writer nothing(answer_, sizeof answer_, false);
        nothing.number(0);
        exchange_.reply_length = nothing.size();
        return 0;
      }
      if (result == URBI_FAILED)
        throw HostError(std::string(reinterpret_cast<const char*>(exchange_.reply),
                                    static_cast<size_t>(exchange_.reply_length)));
      return result;
    }
  }
}

#endif
