/// Which threaded calls exclude one another.
#ifndef URBI_LOCK_MODE_HH
#define URBI_LOCK_MODE_HH

namespace urbi
{
  enum LockMode
  {
    LOCK_NONE,     ///< None do.
    LOCK_FUNCTION, ///< Calls of the same function; for notifications, those about one variable.
    LOCK_INSTANCE, ///< Calls of any function of the same object.
    LOCK_CLASS,    ///< Calls of any function of any object of the class.
    LOCK_MODULE,   ///< Calls of any function of this module.
  };

  /// How a threaded function is locked.
  class LockSpec
  {
  public:
    /// \param maximum  how many calls there may be at a time, those above are dropped; 0 for any number
    constexpr LockSpec(LockMode mode, unsigned maximum = 0)
      : lockMode(mode)
      , maxQueueSize(maximum)
    {}

    LockMode lockMode;
    unsigned maxQueueSize;
  };

  /// One call of a function at a time; what comes meanwhile is dropped.
  constexpr LockSpec LOCK_FUNCTION_DROP(LOCK_FUNCTION, 1);

  /// One call of a function at a time, and one that waits; what comes meanwhile is dropped.
  constexpr LockSpec LOCK_FUNCTION_KEEP_ONE(LOCK_FUNCTION, 2);
}

#endif
