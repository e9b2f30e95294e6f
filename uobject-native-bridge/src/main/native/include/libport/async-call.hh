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
      AsyncCalls();

      /// Forgets all calls, and waits a while for the one that is made. Calls can be added again
      /// after that: a library that has been closed may stay where it is, and be opened once more.
      /// \return whether the thread has gone
      bool end();

      AsyncCallHandler add(const std::function<void()>& function, utime_t delay);

    private:
      void run();

      std::mutex lock_;
      std::condition_variable changed_;
      std::multimap<std::chrono::steady_clock::time_point, AsyncCallHandler> calls_;
      std::thread thread_;
      bool ended_;
      bool left_; ///< whether there is no thread, or it has nothing more to do
    };

    /// The calls of this module. They outlive its static variables: when the process of its host ends
    /// the thread is left alone, for it may wait for a host that answers no more.
    LIBPORT_LOCAL AsyncCalls& async_calls();
  }

  /// Has a function called after so many microseconds.
  template <typename Function>
  AsyncCallHandler asyncCall(const Function& function, utime_t delay = 0)
  {
    return detail::async_calls().add([function]() mutable { function(); }, delay);
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/async-call.hh>
#endif

#endif
