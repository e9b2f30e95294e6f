/// Threads.
#ifndef LIBPORT_THREAD_HH
#define LIBPORT_THREAD_HH

#include <functional>
#include <pthread.h>
#include <system_error>

#include <libport/lockable.hh>
#include <libport/semaphore.hh>

namespace libport
{
  namespace detail
  {
    inline void* run_thread(void* given)
    {
      std::function<void()>* task = static_cast<std::function<void()>*>(given);
      std::function<void()> own = std::move(*task);
      delete task;
      own();
      return nullptr;
    }
  }

  /// Starts a thread. \return the one that pthread_join wants
  /// \throw std::system_error if there can be no more
  inline pthread_t startThread(const std::function<void()>& task)
  {
    std::function<void()>* given = new std::function<void()>(task);
    pthread_t thread;
    int error = pthread_create(&thread, nullptr, &detail::run_thread, given);
    if (error)
    {
      delete given;
      throw std::system_error(error, std::generic_category(), "cannot start a thread");
    }
    return thread;
  }

  /// Starts a thread that calls a function of an object.
  template <typename T>
  pthread_t startThread(T* object, void (T::*function)())
  {
    return startThread(std::function<void()>([=] { (object->*function)(); }));
  }

  /// Starts a thread that calls an object without arguments.
  template <typename T>
  pthread_t startThread(T* object)
  {
    return startThread(std::function<void()>([=] { (*object)(); }));
  }
}

#endif
