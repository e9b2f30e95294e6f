/// Which tasks exclude one another.
#ifndef LIBPORT_THREAD_POOL_HH
#define LIBPORT_THREAD_POOL_HH

#include <cstddef>

#include <libport/boost-names.hh>

namespace libport
{
  /// Where tasks run that exclude one another by locks.
  class ThreadPool
  {
  public:
    /// Tasks that have the same one exclude one another.
    class TaskLock
    {
    public:
      /// \param most  how many may run or wait; what comes meanwhile is dropped. 0 for any number
      /// \param excluded  an urbi::LockMode; -1 for those that have this very lock
      explicit TaskLock(size_t most = 0, int excluded = -1)
        : maxQueueSize(most)
        , mode(excluded)
      {}

      size_t maxQueueSize;
      int mode;
    };

    typedef std::shared_ptr<TaskLock> rTaskLock;
  };
}

#endif
