/// Semaphores.
#ifndef LIBPORT_SEMAPHORE_HH
#define LIBPORT_SEMAPHORE_HH

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <libport/utime.hh>

namespace libport
{
  /// A number that is never below 0: who wants to make it so waits.
  class Semaphore
  {
  public:
    explicit Semaphore(unsigned value = 0)
      : value_(static_cast<int>(value))
    {}

    Semaphore(const Semaphore&) = delete;
    Semaphore& operator=(const Semaphore&) = delete;

    void set(unsigned number)
    {
      {
        std::lock_guard<std::mutex> guard(lock_);
        value_ += static_cast<int>(number);
      }
      raised_.notify_all();
    }

    /// Takes so many of it. \param useconds how long to wait at most; 0 for ever
    /// \return whether it has
    bool get(unsigned number = 1, utime_t useconds = 0)
    {
      std::unique_lock<std::mutex> guard(lock_);
      auto enough = [&] { return value_ >= static_cast<int>(number); };
      if (useconds == 0)
        raised_.wait(guard, enough);
      else if (!raised_.wait_for(guard, std::chrono::microseconds(useconds), enough))
        return false;
      value_ -= static_cast<int>(number);
      return true;
    }

    bool uget(utime_t useconds = 0)
    {
      return get(1, useconds);
    }

    Semaphore& operator++()
    {
      set(1);
      return *this;
    }

    Semaphore& operator--()
    {
      get();
      return *this;
    }

    void operator++(int)
    {
      set(1);
    }

    void operator--(int)
    {
      get();
    }

    Semaphore& operator<<(unsigned number)
    {
      set(number);
      return *this;
    }

    Semaphore& operator>>(unsigned number)
    {
      get(number);
      return *this;
    }

    operator int() const
    {
      std::lock_guard<std::mutex> guard(lock_);
      return value_;
    }

  private:
    mutable std::mutex lock_;
    std::condition_variable raised_;
    int value_;
  };
}

#endif
