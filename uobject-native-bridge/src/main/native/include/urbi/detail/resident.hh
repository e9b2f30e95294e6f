/// Who lives in a context, objects and hubs: timers, and the callbacks that belong to them.
#ifndef URBI_DETAIL_RESIDENT_HH
#define URBI_DETAIL_RESIDENT_HH

#include <cstdlib>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include <urbi/detail/callbacks.hh>
#include <urbi/lock-mode.hh>
#include <urbi/ucontext.hh>
#include <urbi/uevent.hh>
#include <urbi/uvar.hh>

namespace urbi
{
  namespace detail
  {
    class Creator;

    class Resident : public urbi::UContext
    {
    public:
      // Names that the code of objects uses without their namespace.
      typedef ::urbi::InputPort InputPort;
      typedef ::urbi::LockSpec LockSpec;
      typedef ::urbi::TimerHandle TimerHandle;
      typedef ::urbi::UBinary UBinary;
      typedef ::urbi::UDictionary UDictionary;
      typedef ::urbi::UEvent UEvent;
      typedef ::urbi::UImage UImage;
      typedef ::urbi::UList UList;
      typedef ::urbi::UObject UObject;
      typedef ::urbi::UObjectHub UObjectHub;
      typedef ::urbi::UObjectList UObjectList;
      typedef ::urbi::USound USound;
      typedef ::urbi::UValue UValue;
      typedef ::urbi::UVar UVar;
      typedef ::urbi::ufloat ufloat;
#define URBI_CONSTANT_(Type, Name) static constexpr ::urbi::Type Name = ::urbi::Name
      URBI_CONSTANT_(UBinaryType, BINARY_NONE);
      URBI_CONSTANT_(UBinaryType, BINARY_UNKNOWN);
      URBI_CONSTANT_(UBinaryType, BINARY_IMAGE);
      URBI_CONSTANT_(UBinaryType, BINARY_SOUND);
      URBI_CONSTANT_(UImageFormat, IMAGE_UNKNOWN);
      URBI_CONSTANT_(UImageFormat, IMAGE_RGB);
      URBI_CONSTANT_(UImageFormat, IMAGE_YCbCr);
      URBI_CONSTANT_(UImageFormat, IMAGE_JPEG);
      URBI_CONSTANT_(UImageFormat, IMAGE_PPM);
      URBI_CONSTANT_(UImageFormat, IMAGE_GREY8);
      URBI_CONSTANT_(USoundFormat, SOUND_RAW);
      URBI_CONSTANT_(USoundFormat, SOUND_WAV);
      URBI_CONSTANT_(USoundSampleFormat, SAMPLE_SIGNED);
      URBI_CONSTANT_(USoundSampleFormat, SAMPLE_UNSIGNED);
      URBI_CONSTANT_(USoundSampleFormat, SAMPLE_FLOAT);
      URBI_CONSTANT_(LockMode, LOCK_NONE);
      URBI_CONSTANT_(LockMode, LOCK_FUNCTION);
      URBI_CONSTANT_(LockMode, LOCK_INSTANCE);
      URBI_CONSTANT_(LockMode, LOCK_CLASS);
      URBI_CONSTANT_(LockMode, LOCK_MODULE);
      URBI_CONSTANT_(LockSpec, LOCK_FUNCTION_DROP);
      URBI_CONSTANT_(LockSpec, LOCK_FUNCTION_KEEP_ONE);
#undef URBI_CONSTANT_

      Resident(const Resident&) = delete;
      Resident& operator=(const Resident&) = delete;

      /// Calls a member function every so many milliseconds, just before a pass of urbiscript code.
      template <typename C, typename R>
      TimerHandle USetTimer(ufloat period, R (C::*function)())
      {
        return named(every(period, bound(this, function).function(), false));
      }

      template <typename C, typename R>
      TimerHandle USetTimer(ufloat period, R (C::*function)() const)
      {
        return named(every(period, bound(this, function).function(), false));
      }

      TimerHandle USetTimer(ufloat period, const std::function<void()>& function);

      /// Ends a timer. \return whether there was such one
      bool removeTimer(const TimerHandle& handle);

      /// Has update called every so many milliseconds, just after a pass of urbiscript code; -1 for
      /// never.
      void USetUpdate(ufloat period);

      /// Called when USetUpdate has asked for it; what it returns does not matter.
      virtual int update();

      static void write_callback(Writer& out, const Callback* callback, const LockSpec* lock);

      /// By which the host knows it.
      static int64_t address_of(const Callback* callback);

    protected:
      friend class Creator;

      Resident(impl::UContextImpl* context, int64_t id);

      virtual ~Resident();

      /// It belongs to this from now on.
      Callback* own(std::unique_ptr<Callback> callback);

      /// Its number on the host's side.
      int64_t id_;

    private:
      static std::string timer_prefix();

      static TimerHandle named(int64_t timer);

      int64_t every(ufloat period, std::unique_ptr<Callback> made, bool after);

      int64_t updates_;
      std::mutex lock_;
      std::list<std::unique_ptr<Callback>> callbacks_;
    };
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/resident.hh>
#endif

#endif
