/// What libport/async-call.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <libport/async-call.hh>

#ifndef URBI_DETAIL_CODE_ASYNC_CALL_HH
#define URBI_DETAIL_CODE_ASYNC_CALL_HH

namespace libport
{
  namespace detail
  {
    URBI_INLINE AsyncCalls::AsyncCalls()
      : ended_(false)
      , left_(true)
    {}

    URBI_INLINE bool AsyncCalls::end()
    {
      std::unique_lock<std::mutex> guard(lock_);
      calls_.clear();
      ended_ = true;
      changed_.notify_all();
      if (!changed_.wait_for(guard, std::chrono::seconds(1), [this] { return left_; }))
        return false;
      std::thread gone = std::move(thread_);
      ended_ = false;
      guard.unlock();
      if (gone.joinable())
        gone.join();
      return true;
    }

    URBI_INLINE AsyncCallHandler AsyncCalls::add(const std::function<void()>& function, utime_t delay)
    {
      AsyncCallHandler made = std::make_shared<AsyncCall>(function);
      {
        std::lock_guard<std::mutex> guard(lock_);
        calls_.insert({std::chrono::steady_clock::now() + std::chrono::microseconds(delay), made});
        if (!thread_.joinable())
        {
          left_ = false;
          thread_ = std::thread([this] { run(); });
        }
      }
      changed_.notify_all();
      return made;
    }

    URBI_INLINE void AsyncCalls::run()
    {
      std::unique_lock<std::mutex> guard(lock_);
      while (!ended_)
        if (calls_.empty())
          changed_.wait(guard);
        else if (std::chrono::steady_clock::now() < calls_.begin()->first)
          changed_.wait_until(guard, calls_.begin()->first);
        else
        {
          AsyncCallHandler due = calls_.begin()->second;
          calls_.erase(calls_.begin());
          guard.unlock();
          try
          {
            due->run();
          }
          catch (const std::exception& e)
          {
            std::fprintf(stderr, "exception caught in an asynchronous call: %s\n", e.what());
          }
          guard.lock();
        }
      left_ = true;
      changed_.notify_all();
    }

    URBI_STATE AsyncCalls& async_calls()
    {
      static AsyncCalls* all = [] {
        AsyncCalls* made = new AsyncCalls;
        urbi::detail::module().closers.push_back([made] { return made->end(); });
        return made;
      }();
      return *all;
    }
  }
}

#endif
