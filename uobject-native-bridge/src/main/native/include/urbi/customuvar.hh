/// Variables with something of a component's own.
#ifndef URBI_CUSTOMUVAR_HH
#define URBI_CUSTOMUVAR_HH

#include <string>

#include <urbi/uobject.hh>

namespace urbi
{
  /// A variable with data: functions that are told of it find them.
  template <typename T>
  class CustomUVar : public UVar
  {
  public:
    CustomUVar() = default;

    explicit CustomUVar(const std::string& name, impl::UContextImpl* context = nullptr)
      : UVar(name, context)
    {}

    CustomUVar(const std::string& object, const std::string& slot,
               impl::UContextImpl* context = nullptr)
      : UVar(object, slot, context)
    {}

    CustomUVar(UObject& object, const std::string& slot, impl::UContextImpl* context = nullptr)
      : UVar(object, slot, context)
    {}

    template <typename V>
    CustomUVar& operator=(const V& value)
    {
      UVar::operator=(value);
      return *this;
    }

    T& data()
    {
      return data_;
    }

    /// The data of a variable that is known to be of this class.
    static T& data(UVar& variable)
    {
      return static_cast<CustomUVar<T>&>(variable).data();
    }

    /// Makes the data what the value is.
    static void updateCache(UVar& variable)
    {
      variable.fill(data(variable));
    }

  private:
    T data_ = T();
  };
}

/// Makes a CustomUVar a slot of this object whose data are always its value.
#define UBindCacheVar(Obj, V, T)                                                                  \
  UBindVar(Obj, V);                                                                               \
  ::urbi::createUCallback(*this, &V, "var", &::urbi::CustomUVar<T>::updateCache, V.get_name(), ctx_)

#endif
