/// What urbi/detail/resident.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/detail/resident.hh>

#ifndef URBI_DETAIL_CODE_RESIDENT_HH
#define URBI_DETAIL_CODE_RESIDENT_HH

namespace urbi
{
  namespace detail
  {
    URBI_INLINE bool Resident::removeTimer(const TimerHandle& handle)
    {
      if (!handle || handle->compare(0, timer_prefix().size(), timer_prefix()) != 0)
        return false;
      const char* digits = handle->c_str() + timer_prefix().size();
      char* end = nullptr;
      int64_t timer = std::strtoll(digits, &end, 10);
      return end != digits && !*end && Request(URBI_TIMER_END, context(), timer).send();
    }

    URBI_INLINE void Resident::USetUpdate(ufloat period)
    {
      if (updates_)
        Request(URBI_TIMER_END, context(), updates_).send();
      updates_ = 0;
      if (period >= 0)
        updates_ = every(period, bound(this, &Resident::update).function(), true);
    }

    URBI_INLINE int Resident::update()
    {
      return 0;
    }

    URBI_INLINE void Resident::write_callback(Writer& out, const Callback* callback, const LockSpec* lock)
    {
      out.raw(address_of(callback));
      out.raw(callback->arity());
      out.raw(lock ? static_cast<int64_t>(lock->lockMode) : int64_t(-1));
      out.raw(lock ? static_cast<int64_t>(lock->maxQueueSize) : int64_t(0));
    }

    URBI_INLINE int64_t Resident::address_of(const Callback* callback)
    {
      return static_cast<int64_t>(reinterpret_cast<intptr_t>(callback));
    }

    URBI_INLINE Resident::Resident(impl::UContextImpl* context, int64_t id)
      : urbi::UContext(context)
      , id_(id)
      , updates_(0)
    {}

    URBI_INLINE Resident::TimerHandle Resident::USetTimer(ufloat period, const std::function<void()>& function)
    {
      return named(every(period, bound(function).function(), false));
    }

    URBI_INLINE Callback* Resident::own(std::unique_ptr<Callback> callback)
    {
      std::lock_guard<std::mutex> guard(lock_);
      callbacks_.push_back(std::move(callback));
      return callbacks_.back().get();
    }

    URBI_INLINE std::string Resident::timer_prefix()
    {
      return "timer_";
    }

    URBI_INLINE Resident::TimerHandle Resident::named(int64_t timer)
    {
      return std::make_shared<std::string>(timer_prefix() + std::to_string(timer));
    }

    URBI_INLINE int64_t Resident::every(ufloat period, std::unique_ptr<Callback> made, bool after)
    {
      Callback* callback = own(std::move(made));
      Request request(URBI_EVERY, context(), id_);
      request.out.raw(period);
      request.out.raw(static_cast<int64_t>(after));
      write_callback(request.out, callback, nullptr);
      return request.send();
    }

    URBI_INLINE Resident::~Resident() = default;
  }
}

#endif
