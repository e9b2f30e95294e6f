/// Functions that are called later, on a thread for all of them.
#ifndef LIBPORT_ASYNC_CALL_HH
#define LIBPORT_ASYNC_CALL_HH

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include <libport/compiler.hh>
#include <libport/utime.hh>

#include <urbi/detail/host.hh>

namespace libport
{
  /// A call that is still to come.
  class AsyncCall
  {
  public:
    explicit AsyncCall(const std::function<void()>& function)
      : function_(function)
      , cancelled_(false)
      , executed_(false)
    {}

    /// It does not come any more. One that runs already runs to its end.
    void cancel()
    {
      std::lock_guard<std::mutex> guard(lock_);
      cancelled_ = true;
    }

    bool executed() const
    {
      std::lock_guard<std::mutex> guard(lock_);
      return executed_;
    }

    void run()
    {
      {
        std::lock_guard<std::mutex> guard(lock_);
        if (cancelled_)
          return;
        executed_ = true;
      }
      function_();
    }

  private:
    std::function<void()> function_;
    mutable std::mutex lock_;
    bool cancelled_;
    bool executed_;
  };

  typedef std::shared_ptr<AsyncCall> AsyncCallHandler;

  namespace detail
  {
    /// The calls to come, and the thread that makes them.
    class AsyncCalls
    {
    public:
      AsyncCalls()
        : ended_(false)
        , left_(true)
      {}

      /// Forgets all calls, and waits a while for the one that is made. Calls can be added again
      /// after that: a library that has been closed may stay where it is, and be opened once more.
      /// \return whether the thread has gone
      bool end()
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

      AsyncCallHandler add(const std::function<void()>& function, utime_t delay)
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

    private:
      void run()
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

      std::mutex lock_;
      std::condition_variable changed_;
      std::multimap<std::chrono::steady_clock::time_point, AsyncCallHandler> calls_;
      std::thread thread_;
      bool ended_;
      bool left_; ///< whether there is no thread, or it has nothing more to do
    };

    /// The calls of this module. They outlive its static variables: when the process of its host ends
    /// the thread is left alone, for it may wait for a host that answers no more.
    LIBPORT_LOCAL inline AsyncCalls& async_calls()
    {
      static AsyncCalls* all = [] {
        AsyncCalls* made = new AsyncCalls;
        urbi::detail::module().closers.push_back([made] { return made->end(); });
        return made;
      }();
      return *all;
    }
  }

  /// Has a function called after so many microseconds.
  template <typename Function>
  AsyncCallHandler asyncCall(const Function& function, utime_t delay = 0)
  {
    return detail::async_calls().add([function]() mutable { function(); }, delay);
  }
}

#endif
