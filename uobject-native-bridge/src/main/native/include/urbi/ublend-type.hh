/// What becomes of several assignments at a time to one variable.
#ifndef URBI_UBLEND_TYPE_HH
#define URBI_UBLEND_TYPE_HH

#include <stdexcept>
#include <string>

namespace urbi
{
  enum UBlendType
  {
    UMIX,
    UADD,
    UDISCARD,
    UQUEUE,
    UCANCEL,
    UNORMAL,
  };

  inline bool is_blendtype(int i)
  {
    return UMIX <= i && i <= UNORMAL;
  }

  /// The value of the property `blend` in urbiscript.
  inline const char* name(UBlendType type)
  {
    switch (type)
    {
    case UMIX: return "mix";
    case UADD: return "add";
    case UDISCARD: return "discard";
    case UQUEUE: return "queue";
    case UCANCEL: return "cancel";
    case UNORMAL: return "normal";
    }
    return "";
  }

  /// The mode of that name.
  inline UBlendType ublendtype(const std::string& text)
  {
    for (int i = 0; is_blendtype(i); ++i)
      if (text == name(static_cast<UBlendType>(i)))
        return static_cast<UBlendType>(i);
    throw std::runtime_error("unknown blendtype: " + text);
  }
}

#endif
