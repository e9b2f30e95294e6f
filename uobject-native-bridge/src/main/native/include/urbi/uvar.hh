/// Variables of urbiscript.
#ifndef URBI_UVAR_HH
#define URBI_UVAR_HH

#include <map>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include <urbi/ucontext.hh>
#include <urbi/uprop.hh>
#include <urbi/uproperty.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  namespace detail
  {
    class Telling;
  }

  /// A slot of an urbiscript object, which is read and written from any thread. Of an owned one, what
  /// is read here is the target that others have written, and what is written is what they read.
  class UVar : public UContext
  {
    template <typename T>
    using if_number = std::enable_if_t<std::is_arithmetic<T>::value, int>;

  public:
    /// A variable to be bound by UBindVar or init.
    UVar();

    /// The variable `object.slot`.
    explicit UVar(const std::string& name, impl::UContextImpl* context = nullptr);
    UVar(const std::string& object, const std::string& slot, impl::UContextImpl* context = nullptr);
    UVar(UObject& object, const std::string& slot, impl::UContextImpl* context = nullptr);
    UVar(UObject* object, const std::string& slot);

    /// The same variable as another.
    UVar(const UVar& other);
    ~UVar();

    /// Binds it. \throw std::runtime_error if there is no such object
    void init(const std::string& name, impl::UContextImpl* context = nullptr);
    void init(const std::string& object, const std::string& slot,
              impl::UContextImpl* context = nullptr);

    // ---------------------------------------------------------------- writing

    template <typename T>
    UVar& operator=(const T& value);

    /// Takes the value of the other.
    UVar& operator=(const UVar& other);

    /// Writes a number.
    void reset(ufloat value);

    // ---------------------------------------------------------------- reading

    /// The value. It stays as it is until the variable is read again.
    const UValue& val() const;
    const UValue& operator*() const;
    UDataType type() const;

    template <typename T>
    T as() const;
    template <typename T>
    T as(T*) const;

    /// Makes an object what the value is.
    template <typename T>
    T& fill(T& object) const;

    template <typename T, if_number<T> = 0>
    operator T() const;
    operator std::string() const;
    operator const UBinary&() const;
    operator UBinary*() const;
    operator UImage() const;
    operator USound() const;
    operator UList() const;
    operator UDictionary() const;

    template <typename T>
    bool operator==(const T& other) const;
    template <typename T>
    bool operator!=(const T& other) const;

    /// The number that is read here, and the one that was written here last; NaN if it is none.
    ufloat in() const;
    ufloat out() const;

    /// When it was written last, in microseconds since the kernel was started.
    utime_t timestamp() const;

    // ---------------------------------------------------------------- what becomes of it

    /// From now on this module owns the variable, see UOwned.
    void setOwned();

    /// Asks the kernel for the value, and waits for it.
    void syncValue();

    /// Has every change sent here.
    void keepSynchronized();

    /// Ends all notifications, and the synchronization of the value.
    void unnotify();

    /// Switches the 0-copy mode: binaries that are written are not copied, and can be read during
    /// notifications only. \return whether it can be: only plugged
    bool setBypass(bool enable = true);

    /// Whether changes may travel in datagrams.
    void useRTP(bool enable = true);

    UValue getProp(UProperty property) const;
    void setProp(UProperty property, const UValue& value);
    void setProp(UProperty property, ufloat value);
    void setProp(UProperty property, const char* value);
    void setProp(UProperty property, const std::string& value);

    bool owned;
    UProp rangemin;
    UProp rangemax;
    UProp speedmin;
    UProp speedmax;
    UProp delta;
    UProp blend;
    UProp constant;

    const std::string& get_name() const
    {
      return name_;
    }

    /// Whether it was made for an argument of a function, and ends with the call.
    bool get_temp() const
    {
      return temp_;
    }

    void set_temp(bool temp)
    {
      temp_ = temp;
    }

    void set_name(const std::string& name)
    {
      name_ = name;
    }

    /// Whether changes may travel in datagrams.
    enum RtpMode
    {
      RTP_DEFAULT, ///< as all do
      RTP_YES,
      RTP_NO,
    };

    RtpMode get_rtp() const
    {
      return rtp_;
    }

    void set_rtp(const RtpMode& mode)
    {
      rtp_ = mode;
    }

    /// \throw std::runtime_error if it is not bound
    void check() const;

  protected:
    /// Whether it keeps no value, but passes it on.
    bool port_ = false;

  private:
    friend class UGenericCallback;
    friend class detail::Telling;

    /// Takes the value of which a function is about to be told.
    void tell(detail::Reader& in);

    /// Whether this thread is being told of the value.
    bool is_told() const;

    void bind(const std::string& name);
    void close() noexcept;
    detail::Request& read(detail::Request& request) const;
    void write(const UValue& value);
    template <typename T>
    void write_binary(const T& value);

    std::string name_;
    int64_t slot_;
    bool temp_;
    RtpMode rtp_;
    /// The value that was last read on this thread; to be used with the lock held.
    UValue& kept() const;

    /// The same, to be looked at without the lock: nobody else changes it.
    UValue& own() const;

    mutable std::mutex lock_;
    mutable std::thread::id first_; ///< whose `value_` is
    mutable UValue value_;
    mutable std::map<std::thread::id, UValue> others_; ///< of other threads
  };

  /// A port, into which urbiscript leads the values of variables by `>>`.
  class InputPort : public UVar
  {
  public:
    InputPort()
    {
      port_ = true;
    }

    InputPort(const std::string& object, const std::string& slot,
              impl::UContextImpl* context = nullptr)
      : InputPort()
    {
      init(object, slot, context);
    }

    InputPort(UObject* object, const std::string& slot, impl::UContextImpl* context = nullptr);

    using UVar::init;
    void init(UObject* object, const std::string& slot, impl::UContextImpl* context = nullptr);

    InputPort(const InputPort& other)
      : InputPort()
    {
      if (!other.get_name().empty())
        init(other.get_name(), other.ctx_);
    }

    InputPort& operator=(const InputPort& other)
    {
      if (this != &other && !other.get_name().empty())
        init(other.get_name(), other.ctx_);
      return *this;
    }
  };

  std::ostream& operator<<(std::ostream& out, const UVar& variable);
}

#include <urbi/uvar.hxx>

#endif
