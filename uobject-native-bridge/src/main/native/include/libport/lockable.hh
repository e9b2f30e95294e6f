/// Locks.
#ifndef LIBPORT_LOCKABLE_HH
#define LIBPORT_LOCKABLE_HH

#include <mutex>

namespace libport
{
  /// A lock that a thread may take several times.
  class Lockable
  {
  public:
    Lockable() = default;

    /// A copy is a lock of its own.
    Lockable(const Lockable&)
    {}

    Lockable& operator=(const Lockable&)
    {
      return *this;
    }

    void lock() const
    {
      mutex_.lock();
    }

    void unlock() const
    {
      mutex_.unlock();
    }

    /// Takes it unless another thread has it.
    bool tryLock() const
    {
      return mutex_.try_lock();
    }

  private:
    mutable std::recursive_mutex mutex_;
  };

  /// Has a lock as long as it lives.
  class BlockLock
  {
  public:
    explicit BlockLock(const Lockable& lock)
      : lock_(lock)
    {
      lock_.lock();
    }

    explicit BlockLock(const Lockable* lock)
      : BlockLock(*lock)
    {}

    ~BlockLock()
    {
      lock_.unlock();
    }

    BlockLock(const BlockLock&) = delete;
    BlockLock& operator=(const BlockLock&) = delete;

  private:
    const Lockable& lock_;
  };

  /// A value with its lock.
  template <typename T>
  class Locked : public Lockable
  {
  public:
    Locked() = default;

    explicit Locked(const T& value)
      : value_(value)
    {}

    T get() const
    {
      BlockLock lock(*this);
      return value_;
    }

    void set(const T& value)
    {
      BlockLock lock(*this);
      value_ = value;
    }

  private:
    T value_;
  };
}

#endif
