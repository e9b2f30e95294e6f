/// Properties of variables.
#ifndef URBI_UPROP_HH
#define URBI_UPROP_HH

#include <urbi/ublend-type.hh>
#include <urbi/uproperty.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  /// A property of a variable, which is read and written as if it were one itself.
  class UProp
  {
  public:
    UProp(UVar& variable, UProperty property)
      : owner(variable)
      , name(property)
    {}

    UProp(const UProp&) = delete;
    UProp& operator=(const UProp&) = delete;

    UProp& operator=(const UValue& v);
    UProp& operator=(ufloat v);
    UProp& operator=(const std::string& v);
    UProp& operator=(const char* v);
    UProp& operator=(UBlendType v);

    operator ufloat() const;
    operator std::string() const;
    operator UValue() const;

  private:
    UVar& owner;
    UProperty name;
  };
}

#endif
