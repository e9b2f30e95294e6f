/// What is to be done at the end of a block.
#ifndef LIBPORT_FINALLY_HH
#define LIBPORT_FINALLY_HH

#include <functional>
#include <list>

namespace libport
{
  /// Calls functions when it ends, those that came last first.
  class Finally
  {
  public:
    typedef std::function<void()> action_type;

    Finally() = default;

    explicit Finally(const action_type& action)
    {
      actions_.push_front(action);
    }

    ~Finally()
    {
      for (const action_type& each : actions_)
        each();
    }

    Finally(const Finally&) = delete;
    Finally& operator=(const Finally&) = delete;

    Finally& operator<<(const action_type& action)
    {
      actions_.push_front(action);
      return *this;
    }

  private:
    std::list<action_type> actions_;
  };
}

#endif
