/// What urbi/ucallbacks.hh and urbi/detail/callbacks.hh declare: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/ucallbacks.hh>

#ifndef URBI_DETAIL_CODE_UCALLBACKS_HH
#define URBI_DETAIL_CODE_UCALLBACKS_HH

namespace urbi
{
  namespace detail
  {
    URBI_INLINE Callback::~Callback() = default;
  }

  URBI_INLINE void UGenericCallback::setAsync(libport::ThreadPool::rTaskLock lock)
  {
    LockSpec spec(LOCK_NONE);
    if (lock)
      spec = LockSpec(lock->mode < 0 ? LOCK_CLASS : static_cast<LockMode>(lock->mode),
                      static_cast<unsigned>(lock->maxQueueSize));
    if (operation_ != URBI_FUNCTION)
    {
      detail::Request request(URBI_CALLBACK_END, context(), owner.id_);
      request.out.raw(detail::Resident::address_of(callback_));
      request.send();
    }
    tell(&spec);
  }

  URBI_INLINE UGenericCallback::UGenericCallback(UObject& object, urbi_request operation, const std::string& called,
                   UVar* variable, detail::Callback* callback)
    : UContext(object.ctx_)
    , owner(object)
    , objname(object.__name)
    , name(called)
    , target(variable)
    , nbparam(static_cast<int>(callback->arity()))
    , operation_(operation)
    , callback_(callback)
    , synchronous_(true)
  {}

  URBI_INLINE void UGenericCallback::tell(const LockSpec* lock)
  {
    synchronous_ = !lock;
    if (operation_ == URBI_FUNCTION)
    {
      detail::Request request(operation_, context(), owner.id_);
      request.out.text(name);
      detail::Resident::write_callback(request.out, callback_, lock);
      request.send();
      return;
    }
    detail::Request request(operation_, context(), target->slot_);
    request.out.raw(owner.id_);
    detail::Resident::write_callback(request.out, callback_, lock);
    request.send();
  }
}

#endif
