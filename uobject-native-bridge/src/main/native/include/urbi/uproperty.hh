/// The properties of a variable.
#ifndef URBI_UPROPERTY_HH
#define URBI_UPROPERTY_HH

#include <stdexcept>
#include <string>

namespace urbi
{
  enum UProperty
  {
    PROP_RANGEMIN,
    PROP_RANGEMAX,
    PROP_SPEEDMIN,
    PROP_SPEEDMAX,
    PROP_BLEND,
    PROP_DELTA,
    PROP_CONSTANT,
  };

  inline bool is_propertytype(int i)
  {
    return PROP_RANGEMIN <= i && i <= PROP_CONSTANT;
  }

  /// The name of a property in urbiscript.
  inline const char* name(UProperty property)
  {
    switch (property)
    {
    case PROP_RANGEMIN: return "rangemin";
    case PROP_RANGEMAX: return "rangemax";
    case PROP_SPEEDMIN: return "speedmin";
    case PROP_SPEEDMAX: return "speedmax";
    case PROP_BLEND: return "blend";
    case PROP_DELTA: return "delta";
    case PROP_CONSTANT: return "constant";
    }
    return "";
  }

  /// The property of that name.
  inline UProperty uproperty(const std::string& text)
  {
    for (int i = 0; is_propertytype(i); ++i)
      if (text == name(static_cast<UProperty>(i)))
        return static_cast<UProperty>(i);
    throw std::runtime_error("unknown uproperty: " + text);
  }
}

#endif
